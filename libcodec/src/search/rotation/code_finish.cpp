#include "search/rotation/code_finish.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "search/rotation/least_weight.h"
#include "search/rotation/placement.h"
#include "tagmint/codec/search/lexicode.h"
#include "tagmint/codec/tag_index.h"

namespace tagmint::codec {
namespace {

/// Exchanges of places that are tried to please the complexity rule.
constexpr int kPlacementTries = 1000;

/// The chain without levels that are no farther apart than the next, with true distances.
CodeChain with_true_distances(const CodeChain& chain) {
  CodeChain result;
  result.construction = chain.construction;
  for (const CodeChain::Level& level : chain.levels) {
    const int distance = least_weight(level.code.basis());
    while (!result.levels.empty() && result.levels.back().distance <= distance) {
      result.levels.pop_back();
    }
    if (tags_of(level.code) >= 1) result.levels.push_back({level.code, distance});
  }
  return result;
}

/// Lists the codewords of a generated family instead.
void list_codewords(FamilyParts& family) {
  const TagIndex index(family.generator, family.layout, family.complexity);
  family.codewords = index.codewords(0, family.generator->tags());
  family.generator = nullptr;
}

int least_pair_distance(const std::vector<Codeword>& tags, int bits) {
  int least = kMaxBits;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    least = std::min(least, self_distance(tags[i], bits));
    for (std::size_t j = 0; j < i; ++j) {
      least = std::min(least, rotation_distance(tags[i], tags[j], bits));
    }
  }
  return least;
}

FamilyParts parts_for(const RotationCodeOptions& options) {
  return {.name = {},
          .layout = options.layout,
          .min_hamming = 0,
          .codewords = {},
          .complexity = options.complexity,
          .origin = {},
          .levels = {}};
}

}  // namespace

FamilyParts finish_chain(const CodeChain& found, const RotationCodeOptions& options,
                         RandomChoice& random) {
  const CodeChain chain = with_true_distances(found);
  FamilyParts family = parts_for(options);
  family.generator = std::make_shared<const RotationCode>(
      place_chain(chain, options.layout, options.complexity, kPlacementTries, random));
  const TagIndex index(family.generator, options.layout, options.complexity);
  for (std::size_t i = 0; i < chain.levels.size(); ++i) {
    family.levels.push_back({family.generator->tags(i), chain.levels[i].distance, index.plain(i)});
  }
  family.min_hamming = family.levels.back().min_hamming;
  if (family.levels.back().codes <= kMostListedTags) list_codewords(family);
  return family;
}

FamilyParts finish_union(const std::vector<Codeword>& tags, const RotationCodeOptions& options,
                         RandomChoice& random) {
  FamilyParts family = parts_for(options);
  family.codewords = place_tags(tags, options.layout, options.complexity, kPlacementTries, random);
  const ComplexityJudge judge(options.layout, options.complexity);
  std::sort(family.codewords.begin(), family.codewords.end());
  const auto plain = std::stable_partition(family.codewords.begin(), family.codewords.end(),
                                           [&](Codeword word) { return judge.accepts(word); });
  family.min_hamming = least_pair_distance(family.codewords, options.layout.bits());
  family.levels = {{family.codewords.size(), family.min_hamming,
                    static_cast<std::size_t>(family.codewords.end() - plain)}};
  return family;
}

std::size_t fill_up(FamilyParts& family, const RotationCodeOptions& options) {
  const std::size_t before = family.codewords.size();
  const LexicodeOptions search{.layout = options.layout,
                               .min_hamming = options.min_hamming,
                               .order = {},
                               .complexity = options.complexity,
                               .threads = options.threads,
                               .stop = options.stop};
  SearchState start;
  start.codewords = family.codewords;
  start.walked_codes = before;
  const LexicodeResult result = search_lexicode(search, std::move(start));
  const std::size_t added = result.codewords.size() - before;
  if (result.end != SearchEnd::Complete || added == 0) return 0;
  const bool same_distance = family.min_hamming == options.min_hamming;
  if (!same_distance && added * 8 < before) return 0;
  family.codewords = result.codewords;
  if (same_distance) {
    // The plain tags stay the last ones.
    Level& last = family.levels.back();
    const auto old_end = family.codewords.begin() + static_cast<std::ptrdiff_t>(before);
    std::rotate(old_end - static_cast<std::ptrdiff_t>(last.plain), old_end, family.codewords.end());
    last.codes += added;
  } else {
    family.levels.push_back({family.codewords.size(), options.min_hamming, 0});
  }
  family.min_hamming = options.min_hamming;
  return added;
}

}  // namespace tagmint::codec
