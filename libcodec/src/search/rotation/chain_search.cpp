#include "search/rotation/chain_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "echelon.h"
#include "search/rotation/code_climb.h"

namespace tagmint::codec {
namespace {

/// Whether 4, 2 or 1 divides all weights of the code. The weight of a sum is that of its terms less
/// twice their common bits, so for 4 any two words of a basis must have an even number in common.
bool divides_weights(int divisor, const TurnCode& code) {
  const auto basis = code.basis();
  for (std::size_t i = 0; i < basis.size(); ++i) {
    if (std::popcount(basis[i]) % divisor != 0) return false;
    if (divisor < 4) continue;
    for (std::size_t j = 0; j < i; ++j) {
      if (std::popcount(basis[i] & basis[j]) % 2 != 0) return false;
    }
  }
  return true;
}

bool contains(const TurnCode& outer, const TurnCode& inner) {
  return std::all_of(inner.rows().begin(), inner.rows().end(),
                     [&](Codeword word) { return outer.contains(word); });
}

/// `outer` as a code whose basis begins with that of `inner`.
TurnCode on_top_of(const TurnCode& inner, const TurnCode& outer) {
  TurnCode code = inner;
  code.adjoin(outer.basis());
  return code;
}

/// What the known codes say about one level.
struct LevelFrame {
  TurnCode start;
  const TurnCode* inside = nullptr;
};

LevelFrame frame_of(const TurnCode& floor, int distance, const KnownChain* known) {
  LevelFrame frame{floor, nullptr};
  if (known == nullptr) return frame;
  for (const KnownCode& code : known->codes) {
    if (!contains(code.code, floor)) continue;
    if (code.distance >= distance) {
      frame.start = on_top_of(floor, code.code);
    } else {
      frame.inside = &code.code;
      break;
    }
  }
  return frame;
}

TurnCode search_level(const TurnCode& floor, int distance, LevelFrame frame, const Effort& effort,
                      RandomChoice& random) {
  std::vector<int> divisors;
  for (const int divisor : {4, 2, 1}) {
    if (!divides_weights(divisor, floor)) continue;
    divisors.push_back(divisor);
    // What a whole code obeys need not be asked for less strictly.
    if (frame.inside != nullptr && divides_weights(divisor, *frame.inside)) break;
  }
  TurnCode best = frame.start;
  for (const int divisor : divisors) {
    ClimbRules rules;
    rules.weights = {(distance + divisor - 1) / divisor * divisor, divisor};
    rules.inside = frame.inside;
    WorkBudget budget({effort.words / static_cast<double>(divisors.size()), effort.stop});
    const TurnCode& start = divides_weights(divisor, best) ? best : floor;
    TurnCode code = climb_far(floor, start, rules, random, budget);
    if (code.dimension() > best.dimension()) best = std::move(code);
  }
  return best;
}

}  // namespace

double tags_of(const TurnCode& code) {
  // A half turn less 1 maps the code to a code; what it maps to 0 are the words that it keeps.
  Echelon changes;
  for (const Codeword word : code.rows()) {
    changes.take(word ^ rotate(word, code.bits(), 2));
  }
  return (std::ldexp(1.0, code.dimension()) - std::ldexp(1.0, code.dimension() - changes.rank())) /
         4.0;
}

double value_of(const CodeChain& chain) {
  constexpr double kWhole = 3;
  double value = 0;
  int dimension = 0;
  for (const CodeChain::Level& level : chain.levels) {
    const bool is_whole = &level == &chain.levels.back();
    const double tags = tags_of(level.code);
    const bool is_new = level.code.dimension() > dimension;
    dimension = level.code.dimension();
    if (tags >= 1 && (is_new || is_whole)) value += (is_whole ? kWhole : 1.0) * std::log2(tags);
  }
  return value;
}

CodeChain search_chain(int bits, std::span<const int> distances, const KnownChain* known, bool vary,
                       const Effort& effort, RandomChoice& random) {
  constexpr std::size_t kMostGivenWay = 3;
  CodeChain chain;
  chain.construction = known != nullptr ? known->name : "quasi-cyclic search";
  std::optional<KnownChain> some;
  if (known != nullptr && vary) {
    some = *known;
    std::erase_if(some->codes, [&](const KnownCode&) { return random.below(2) == 0; });
    known = &*some;
  }
  TurnCode floor(bits);
  for (const int distance : distances) {
    TurnCode code = search_level(floor, distance, frame_of(floor, distance, known), effort, random);
    if (vary && distance != distances.back()) {
      const int given_way = static_cast<int>(random.below(kMostGivenWay));
      code = code.prefix(std::max(floor.dimension(), code.dimension() - given_way));
    }
    floor = std::move(code);
    chain.levels.push_back({floor, distance});
  }
  return chain;
}

CodeChain search_chain_upward(int bits, std::span<const int> distances, const KnownChain* known,
                              const Effort& effort, RandomChoice& random) {
  const TurnCode none(bits);
  LevelFrame frame = frame_of(none, distances.back(), known);
  frame.inside = nullptr;
  const CodeChain::Level whole{
      search_level(none, distances.back(), std::move(frame), effort, random), distances.back()};
  CodeChain chain = search_inside(whole, distances.first(distances.size() - 1), effort, random);
  chain.construction = known != nullptr ? known->name : "quasi-cyclic search";
  return chain;
}

CodeChain search_inside(const CodeChain::Level& whole, std::span<const int> distances,
                        const Effort& effort, RandomChoice& random) {
  const TurnCode none(whole.code.bits());
  std::vector<CodeChain::Level> found = {whole};
  for (auto distance = distances.rbegin(); distance != distances.rend(); ++distance) {
    const TurnCode outer = found.back().code;
    TurnCode code = search_level(none, *distance, {none, &outer}, effort, random);
    if (tags_of(code) < 1) break;
    found.push_back({std::move(code), *distance});
  }
  CodeChain chain;
  TurnCode floor = none;
  for (auto level = found.rbegin(); level != found.rend(); ++level) {
    floor = on_top_of(floor, level->code);
    chain.levels.push_back({floor, level->distance});
  }
  return chain;
}

}  // namespace tagmint::codec
