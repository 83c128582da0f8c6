#include "level_distances.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <optional>
#include <span>

#include "echelon.h"
#include "pair_distances.h"
#include "search/parallel.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

using Address = RotationCode::Address;

constexpr std::uint64_t kWordsAtATime = 1024;

/// The words of a level, numbered coset by coset.
class LevelWords {
 public:
  LevelWords(const RotationCode& code, std::size_t level)
      : code_(code), level_(code.levels()[level]), size_(code.words(level)) {}

  std::uint64_t size() const { return size_; }

  Codeword word(std::uint64_t number) const {
    const std::uint64_t coset = number >> level_.dimension;
    return code_.word(coset << code_.dimension() | (number & low_mask(level_.dimension)));
  }

  /// Some words from `first` on.
  std::vector<Codeword> stretch(std::uint64_t first) const {
    std::vector<Codeword> words(std::min(kWordsAtATime, size_ - first));
    for (Codeword& each : words) each = word(first++);
    return words;
  }

 private:
  const RotationCode& code_;
  RotationCodeLevel level_;
  std::uint64_t size_;
};

/// A coset that stands for those that turns make of it: they see the same distances.
struct CosetOrbit {
  Codeword first_word = 0;
  std::uint64_t cosets = 0;
};

std::vector<CosetOrbit> coset_orbits(const RotationCode& code, std::size_t level) {
  std::vector<CosetOrbit> orbits;
  for (std::uint64_t coset = 0; coset < code.levels()[level].cosets; ++coset) {
    std::vector<std::uint64_t> turns = {coset};
    Address address = coset << code.dimension();
    for (int turn = 1; turn < 4; ++turn) {
      address = code.turned(address);
      turns.push_back(address >> code.dimension());
    }
    std::sort(turns.begin(), turns.end());
    if (turns.front() != coset) continue;
    const auto end = std::unique(turns.begin(), turns.end());
    orbits.push_back(
        {code.word(coset << code.dimension()), static_cast<std::uint64_t>(end - turns.begin())});
  }
  return orbits;
}

/// Whether at least three of four words of each coset are turns of tags. Of the pairs of words with
/// one difference at most half then have a word that is none, so each distance between words is one
/// between turns of tags.
bool most_words_are_tags(const RotationCode& code, std::size_t level) {
  const auto half_turn = [&](Address address) { return code.turned(code.turned(address)); };
  Echelon differences;
  for (int i = 0; i < code.levels()[level].dimension; ++i) {
    const Address message = Address{1} << i;
    const Address turned = half_turn(message) ^ half_turn(0);
    differences.take((turned & low_mask(code.dimension())) ^ message);
  }
  return differences.rank() >= 2;  // words fixed by a half turn: 2^-rank of a coset, or none
}

/// By comparing all tags of the level.
int compared_distance(const TagIndex& index, std::size_t level, int threads) {
  const int bits = index.code()->bits();
  const std::vector<Codeword> tags = index.codewords(0, index.code()->tags(level));
  const Level all{tags.size(), 1};
  const DistanceHistogram pairs = pair_histograms(tags, bits, std::span(&all, 1), threads).front();
  const auto used = std::find_if(pairs.begin(), pairs.end(), [](auto n) { return n > 0; });
  int least = used == pairs.end() ? bits : static_cast<int>(used - pairs.begin());
  for (const Codeword tag : tags) least = std::min(least, self_distance(tag, bits));
  return least;
}

}  // namespace

DistanceHistogram level_distances(const RotationCode& code, std::size_t level, int threads) {
  const LevelWords words(code, level);
  const std::vector<CosetOrbit> orbits = coset_orbits(code, level);
  const int workers = thread_count(threads);
  std::vector<DistanceHistogram> parts(workers, DistanceHistogram{});
  std::atomic<std::uint64_t> next{0};
  run_workers(workers, [&](int worker) {
    for (std::uint64_t first; (first = next.fetch_add(kWordsAtATime)) < words.size();) {
      const std::vector<Codeword> stretch = words.stretch(first);
      for (const CosetOrbit& orbit : orbits) {
        DistanceHistogram seen{};
        add_distances(stretch, orbit.first_word, seen);
        for (std::size_t distance = 0; distance < seen.size(); ++distance) {
          parts[worker][distance] += orbit.cosets * seen[distance];
        }
      }
    }
  });
  DistanceHistogram sum{};
  for (const DistanceHistogram& part : parts) {
    std::transform(part.begin(), part.end(), sum.begin(), sum.begin(), std::plus<>());
  }
  return sum;
}

int tag_distance(const TagIndex& index, std::size_t level, const DistanceHistogram& distances,
                 int threads) {
  if (!most_words_are_tags(*index.code(), level)) return compared_distance(index, level, threads);
  const auto used =
      std::find_if(distances.begin() + 1, distances.end(), [](auto n) { return n > 0; });
  return static_cast<int>(used - distances.begin());
}

std::vector<TagId> near_tags(const TagIndex& index, std::size_t level, int min_hamming) {
  const RotationCode& code = *index.code();
  const LevelWords words(code, level);
  const std::uint64_t coset_size = std::uint64_t{1} << code.levels()[level].dimension;
  // Two words of the level whose turns of tags have the same difference.
  const auto find_pair = [&](Codeword difference, std::uint64_t coset) -> std::vector<TagId> {
    for (std::uint64_t i = coset * coset_size; i < (coset + 1) * coset_size; ++i) {
      const auto a = index.find(words.word(i));
      const auto b = a ? index.find(words.word(i) ^ difference) : std::nullopt;
      if (!b) continue;
      if (a->id == b->id) return {a->id};
      return {std::min(a->id, b->id), std::max(a->id, b->id)};
    }
    return {};
  };
  for (std::uint64_t coset = 0; coset < code.levels()[level].cosets; ++coset) {
    const Codeword from = words.word(coset * coset_size);
    for (std::uint64_t first = 0; first < words.size(); first += kWordsAtATime) {
      const std::vector<Codeword> stretch = words.stretch(first);
      for (std::size_t at = 0; at < stretch.size(); ++at) {
        at += first_within(std::span(stretch).subspan(at), from, min_hamming - 1);
        if (at >= stretch.size() || stretch[at] == from) continue;
        const std::vector<TagId> pair = find_pair(stretch[at] ^ from, coset);
        if (!pair.empty()) return pair;
      }
    }
  }
  return {};
}

}  // namespace tagmint::codec
