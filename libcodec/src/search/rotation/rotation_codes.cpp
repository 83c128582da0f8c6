#include "tagmint/codec/search/rotation_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "search/rotation/code_climb.h"
#include "search/rotation/code_finish.h"
#include "search/rotation/coset_union.h"
#include "search/rotation/free_code.h"
#include "search/rotation/tries.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/search/size_bound.h"
#include "tagmint/codec/version.h"

namespace tagmint::codec {
namespace {

/// Words that a try compares for each level of a chain: half a second to two.
constexpr double kWordsPerLevel = 4e9;

/// Words that the search for a free code compares in each attempt: half a minute. Where there are
/// such codes, a tenth of it mostly does.
constexpr double kFreeWords = 2e10;

/// Largest layouts for unions of cosets, and for filling up.
constexpr int kMostUnionBits = 25;
constexpr int kMostFilledBits = 41;

RandomChoice random_for(const RotationCodeOptions& options, std::size_t step, std::size_t number) {
  constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio
  return RandomChoice(options.seed + kOdd * (64 * number + step + 1));
}

void check_options(const RotationCodeOptions& options) {
  const int bits = options.layout.bits();
  if (options.min_hamming < 1 || options.min_hamming > bits) {
    throw std::invalid_argument(
        fmt::format("minimum Hamming distance {} is not possible with {} bits; 1 to {} are",
                    options.min_hamming, bits, bits));
  }
  for (const int level : options.levels) {
    if (level <= options.min_hamming || level > bits) {
      throw std::invalid_argument(
          fmt::format("a level of distance {} is not possible inside a family of distance {} with "
                      "{} bits; {} to {} are",
                      level, options.min_hamming, bits, options.min_hamming + 1, bits));
    }
  }
  if (options.attempts < 1) {
    throw std::invalid_argument(
        fmt::format("{} attempts are not possible; at least 1 is", options.attempts));
  }
}

/// The distances that are asked for, largest first.
std::vector<int> falling_distances(const RotationCodeOptions& options) {
  std::vector<int> distances = options.levels;
  distances.push_back(options.min_hamming);
  std::sort(distances.begin(), distances.end(), std::greater<>());
  distances.erase(std::unique(distances.begin(), distances.end()), distances.end());
  return distances;
}

/// Distances to look for inside a code of the distance that is asked for: by steps of two, up to
/// half of the bits.
std::vector<int> inner_distances(const RotationCodeOptions& options) {
  std::vector<int> distances;
  for (int distance = options.layout.bits() / 2; distance > options.min_hamming; --distance) {
    if ((distance - options.min_hamming) % 2 == 0) distances.push_back(distance);
  }
  return distances;
}

/// The search in its steps; each is nothing when it was stopped.
class CodeSearch {
 public:
  explicit CodeSearch(const RotationCodeOptions& options) : options_(options) {}

  RotationCodeResult run() {
    std::optional<CodeChain> chain = best_chain();
    if (chain) chain = with_free_code(std::move(*chain));
    if (chain && options_.levels.empty() && tags_of(chain->levels.back().code) >= 1) {
      chain = with_inner_levels(*chain);
    }
    if (!chain) return stopped();
    const std::optional<std::vector<Codeword>> tags = best_union();
    if (!tags) return stopped();
    RandomChoice random = random_for(options_, 63, 0);
    RotationCodeResult result = nothing();
    const double chain_tags = tags_of(chain->levels.back().code);
    if (tags->empty() && chain_tags < 1) return result;
    result.construction = chain->construction;
    if (static_cast<double>(tags->size()) > chain_tags) {
      result.parts = finish_union(*tags, options_, random);
      result.construction = "union of cosets";
    } else {
      result.parts = finish_chain(*chain, options_, random);
    }
    if (result.parts.generator == nullptr && options_.layout.bits() <= kMostFilledBits) {
      const std::size_t added = fill_up(result.parts, options_);
      if (added > 0) result.construction += fmt::format(", {} words of a lexicode added", added);
    }
    if (options_.stop.stop_requested()) return stopped();
    return result;
  }

 private:
  RotationCodeResult nothing() const {
    return {.parts = {.name = {},
                      .layout = options_.layout,
                      .min_hamming = 0,
                      .codewords = {},
                      .complexity = {},
                      .origin = {},
                      .levels = {}},
            .construction = {},
            .stopped = false};
  }

  RotationCodeResult stopped() const {
    RotationCodeResult result = nothing();
    result.stopped = true;
    return result;
  }

  Effort effort(double words) const { return {words, options_.stop}; }

  /// The best of several tries by `value`, the first on ties.
  template <typename Result>
  std::optional<Result> best_try(const std::string& step, std::size_t count,
                                 const std::function<Result(std::size_t)>& make,
                                 const std::function<double(const Result&)>& value) {
    auto results = make_tries<Result>(count, options_.threads, options_.stop, make,
                                      [&](std::size_t done) { tell(step, done, count); });
    if (!results) return std::nullopt;
    const auto best =
        std::max_element(results->begin(), results->end(),
                         [&](const Result& a, const Result& b) { return value(a) < value(b); });
    return std::move(*best);
  }

  void tell(const std::string& step, std::size_t done, std::size_t count) const {
    if (options_.progress) options_.progress({done, count, step, tags_});
  }

  std::optional<CodeChain> best_chain() {
    const std::vector<int> distances = falling_distances(options_);
    std::vector<KnownChain> known = known_chains();
    std::erase_if(known, [&](const KnownChain& chain) {
      return chain.codes.front().distance < options_.min_hamming;
    });
    const std::size_t sources = known.size() + 1;
    const auto make = [&](std::size_t number) {
      const int bits = options_.layout.bits();
      RandomChoice random = random_for(options_, 0, number);
      const std::size_t source = number % sources;
      std::optional<KnownChain> fitted;
      if (source > 0) fitted = fit_chain(known[source - 1], bits, random);
      const KnownChain* const start = fitted ? &*fitted : nullptr;
      // The first attempt goes downward through the distances, the second upward, and so on.
      const std::size_t attempt = number / sources;
      if (attempt % 2 == 1 && distances.size() > 1) {
        return search_chain_upward(bits, distances, start, effort(kWordsPerLevel), random);
      }
      return search_chain(bits, distances, start, attempt > 0, effort(kWordsPerLevel), random);
    };
    auto best = best_try<CodeChain>("codes", sources * static_cast<std::size_t>(options_.attempts),
                                    make, value_of);
    if (best) tags_ = tags_of(best->levels.back().code);
    return best;
  }

  /// A free code with four or less dimensions more than `chain`'s last, and levels inside it, where
  /// one is found and that is the better chain; else `chain`.
  std::optional<CodeChain> with_free_code(CodeChain chain) {
    const int bits = options_.layout.bits();
    const int generators = chain.levels.back().code.dimension() / 4 + 1;
    const double tags = std::ldexp(1.0, 4 * generators - 2);
    if (generators < 2 || generators > kMostFreeGenerators || bits / 4 <= generators ||
        tags > upper_bound_of_tags(bits, options_.min_hamming).tags) {
      return chain;
    }
    const auto make = [&](std::size_t number) {
      RandomChoice random = random_for(options_, 4, number);
      WorkBudget budget(effort(kFreeWords));
      const auto found =
          find_free_code(bits - bits % 4, generators, options_.min_hamming, random, budget);
      return found ? chain_in_free_code(*found, random) : chain;
    };
    auto best = best_try<CodeChain>("free codes", static_cast<std::size_t>(options_.attempts), make,
                                    value_of);
    if (!best || value_of(*best) <= value_of(chain)) return best ? chain : best;
    tags_ = tags_of(best->levels.back().code);
    return best;
  }

  /// The levels that are found inside a free code, whose centre bit is 0.
  CodeChain chain_in_free_code(const TurnCode& free_code, RandomChoice& random) const {
    const int bits = options_.layout.bits();
    std::vector<Codeword> words;
    for (const Codeword word : free_code.basis()) words.push_back(word << (bits % 4));
    TurnCode code(bits);
    code.adjoin(words);
    const std::vector<int> distances = falling_distances(options_);
    const KnownChain known{"lifted quasi-cyclic code", bits, {{code, options_.min_hamming}}};
    CodeChain downward =
        search_chain(bits, distances, &known, false, effort(kWordsPerLevel), random);
    // The other way round a large level of a small distance may leave none of the larger one.
    CodeChain upward = search_inside({code, options_.min_hamming},
                                     std::span(distances).first(distances.size() - 1),
                                     effort(kWordsPerLevel), random);
    upward.construction = known.name;
    constexpr double kSame = 1e-9;  // sums of logarithms
    return value_of(upward) > value_of(downward) + kSame ? upward : downward;
  }

  std::optional<CodeChain> with_inner_levels(const CodeChain& whole) {
    const std::vector<int> distances = inner_distances(options_);
    const auto make = [&](std::size_t number) {
      RandomChoice random = random_for(options_, 1, number);
      return search_inside(whole.levels.back(), distances, effort(kWordsPerLevel), random);
    };
    auto best = best_try<CodeChain>("inner levels", static_cast<std::size_t>(options_.attempts),
                                    make, value_of);
    if (best) best->construction = whole.construction;
    return best;
  }

  std::optional<std::vector<Codeword>> best_union() {
    const int bits = options_.layout.bits();
    if (!options_.levels.empty() || bits > kMostUnionBits) return std::vector<Codeword>();
    // Whether a kernel serves shows after a short search; the best ones then get a long one.
    constexpr std::size_t kKernels = 48;  // an attempt
    constexpr double kShortWords = 1e8;
    constexpr double kLongWords = 1e9;
    struct Union {
      TurnCode kernel;
      std::vector<Codeword> tags;
    };
    const std::size_t kernels = kKernels * static_cast<std::size_t>(options_.attempts);
    const auto begin = [&](std::size_t number) {
      RandomChoice random = random_for(options_, 2, number);
      Union tried{random_kernel(random), {}};
      WorkBudget budget(effort(kShortWords));
      tried.tags = unite_cosets(tried.kernel, options_.min_hamming, random, budget);
      return tried;
    };
    auto begun =
        make_tries<Union>(kernels, options_.threads, options_.stop, begin,
                          [&](std::size_t done) { tell("unions of cosets", done, kernels); });
    if (!begun) return std::nullopt;
    std::stable_sort(begun->begin(), begun->end(),
                     [](const Union& a, const Union& b) { return a.tags.size() > b.tags.size(); });
    const std::size_t finalists = kernels / 8;
    const auto go_on = [&](std::size_t number) {
      RandomChoice random = random_for(options_, 3, number);
      WorkBudget budget(effort(kLongWords));
      return unite_cosets((*begun)[number].kernel, options_.min_hamming, random, budget);
    };
    auto best = best_try<std::vector<Codeword>>(
        "unions of cosets, the best ones", finalists, go_on,
        [](const std::vector<Codeword>& tags) { return static_cast<double>(tags.size()); });
    if (best && begun->front().tags.size() > best->size()) best = std::move(begun->front().tags);
    return best;
  }

  /// A closed code that is far enough apart and small: 2^17 to 2^19 cosets, or fewer for a short
  /// word.
  TurnCode random_kernel(RandomChoice& random) const {
    constexpr int kMostCosetBits = 19;
    const int bits = options_.layout.bits();
    const int dimension = std::max(1, bits - kMostCosetBits) + static_cast<int>(random.below(3));
    ClimbRules rules;
    const int divisor = random.below(2) == 0 ? 1 : 4;
    rules.weights = {(options_.min_hamming + divisor - 1) / divisor * divisor, divisor};
    rules.most_dimensions = dimension;
    WorkBudget budget(effort(kWordsPerLevel));
    TurnCode kernel = climb(TurnCode(bits), rules, random, budget);
    // Where there is no code so large, what is found must do; it may be too small to unite.
    return bits - kernel.dimension() <= kMostClassBits ? kernel : TurnCode(bits);
  }

  const RotationCodeOptions& options_;
  double tags_ = 0;  // of the best code so far
};

}  // namespace

RotationCodeResult search_rotation_code(const RotationCodeOptions& options) {
  check_options(options);
  RotationCodeResult result = CodeSearch(options).run();
  result.parts.origin = {
      .method = "rotation-code",
      .order = {},
      .seed = std::to_string(options.seed),
      .searched = fmt::format("{}; {} attempt{}", result.construction, options.attempts,
                              options.attempts == 1 ? "" : "s"),
      .program = fmt::format("tagmint {}", kVersion)};
  return result;
}

Family make_family(RotationCodeResult result, std::string name) {
  if (name.empty()) {
    name = fmt::format("rot{}{}h{}", layout_family_prefix(result.parts.layout),
                       result.parts.layout.bits(), result.parts.min_hamming);
  }
  result.parts.name = std::move(name);
  return Family(std::move(result.parts));
}

}  // namespace tagmint::codec
