#include "search/rotation/placement.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "echelon.h"

namespace tagmint::codec {
namespace {

/// Most words that one try judges.
constexpr std::size_t kMostSample = 2048;

Placement unmoved(int bits) {
  const auto places = static_cast<std::size_t>(bits / 4);
  Placement placement{bits, std::vector<int>(places), std::vector<int>(places, 0)};
  std::iota(placement.place.begin(), placement.place.end(), 0);
  return placement;
}

/// A judge of words as they will stand in the tag. The rule `rectangles` is slow and depends on the
/// turn, so that energy, which goes along with it, stands in for it here.
ComplexityJudge sample_judge(const Layout& layout, const Complexity& rule) {
  constexpr Complexity kEnergy{ComplexityRule::Energy, 0.3333};
  return {layout, rule.rule == ComplexityRule::Rectangles ? kEnergy : rule};
}

/// All sums of the first words, as many as do not give more than `most`.
std::vector<Codeword> sums_of(const std::vector<Codeword>& words, std::size_t most) {
  std::vector<Codeword> sums = {0};
  for (const Codeword word : words) {
    if (2 * sums.size() > most) break;
    const std::size_t half = sums.size();
    for (std::size_t i = 0; i < half; ++i) sums.push_back(sums[i] ^ word);
  }
  return sums;
}

/// How many words of each level are words of tags, when all are translated by `t`; as the sum of
/// their logarithms.
double value_with(const CodeChain& chain, Codeword t) {
  const auto half_turn_change = [&](Codeword word) {
    return word ^ rotate(word, chain.levels.front().code.bits(), 2);
  };
  double value = 0;
  for (const CodeChain::Level& level : chain.levels) {
    Echelon changes;
    for (const Codeword word : level.code.rows()) changes.take(half_turn_change(word));
    const double words = std::ldexp(1.0, level.code.dimension());
    const bool some_stay = changes.reduce(half_turn_change(t)).rest == 0;
    const double kept = some_stay ? std::ldexp(1.0, level.code.dimension() - changes.rank()) : 0.0;
    if (words > kept) value += std::log2(words - kept);
  }
  return value;
}

/// The translations that make the most tags of a chain, at most kMostSample of them.
std::vector<Codeword> best_translations(const CodeChain& chain) {
  const TurnCode& first = chain.levels.front().code;
  const std::vector<Codeword> all = sums_of(one_step_extensions(first, nullptr), 1 << 17);
  double best_value = 0;
  std::vector<Codeword> best;
  for (const Codeword t : all) {
    constexpr double kSame = 1e-9;
    const double value = value_with(chain, t);
    if (value > best_value + kSame) {
      best_value = value;
      best.clear();
    }
    if (value > best_value - kSame && best.size() < kMostSample) best.push_back(t);
  }
  return best;
}

/// Words whose complexity decides: all of a level, the smallest first, while they are few.
struct Sample {
  std::vector<Codeword> words;
  std::vector<std::size_t> ends;  // of each level in `words`
};

Sample sample_of(const CodeChain& chain) {
  Sample sample;
  std::vector<Codeword> basis;
  for (const CodeChain::Level& level : chain.levels) {
    basis.assign(level.code.basis().begin(), level.code.basis().end());
    sample.words = sums_of(basis, kMostSample);
    sample.ends.push_back(sample.words.size());
    if (sample.words.size() >= kMostSample / 2) break;
  }
  return sample;
}

/// A choice of cells and translation (which is added before the cells are moved), and how good it
/// is.
struct Choice {
  Placement placement;
  Codeword translation = 0;
  double score = -1;
};

/// Exchanges two places, turns one or takes another translation.
Choice neighbour(const Choice& choice, const std::vector<Codeword>& translations,
                 RandomChoice& random) {
  Choice next = choice;
  const std::size_t places = next.placement.place.size();
  const std::size_t one = random.below(places);
  switch (random.below(3)) {
    case 0:
      std::swap(next.placement.place[one], next.placement.place[random.below(places)]);
      break;
    case 1:
      next.placement.blocks[one] = static_cast<int>(random.below(4));
      break;
    default:
      next.translation = random.of(translations);
  }
  return next;
}

/// Hill climbing; `score` fills in how good a choice is.
Choice best_choice(Choice first, const std::vector<Codeword>& translations, int tries,
                   const std::function<double(const Choice&)>& score, RandomChoice& random) {
  first.score = score(first);
  for (int i = 0; i < tries; ++i) {
    Choice next = neighbour(first, translations, random);
    next.score = score(next);
    if (next.score >= first.score) first = std::move(next);
  }
  return first;
}

/// Accepted words, as they stand after a choice.
double accepted(std::span<const Codeword> words, const LinearMap& moved, Codeword translation,
                const ComplexityJudge& judge) {
  return static_cast<double>(std::count_if(words.begin(), words.end(), [&](Codeword word) {
    return judge.accepts(moved(word ^ translation));
  }));
}

}  // namespace

LinearMap Placement::map() const {
  const int places = static_cast<int>(place.size());
  const int centre_bits = bits % 4;
  std::vector<Codeword> columns(static_cast<std::size_t>(bits));
  for (int bit = 0; bit < centre_bits; ++bit) columns[static_cast<std::size_t>(bit)] = 1;
  for (int block = 0; block < 4; ++block) {
    for (int from = 0; from < places; ++from) {
      const auto i = static_cast<std::size_t>(from);
      const int to_block = (block + blocks[i]) & 3;
      const int source = bits - 1 - (block * places + from);
      const int target = bits - 1 - (to_block * places + place[i]);
      columns[static_cast<std::size_t>(source)] = Codeword{1} << target;
    }
  }
  return LinearMap(columns);
}

RotationCodeParts place_chain(const CodeChain& chain, const Layout& layout, const Complexity& rule,
                              int tries, RandomChoice& random) {
  const int bits = layout.bits();
  const std::vector<Codeword> translations = best_translations(chain);
  const Sample sample = sample_of(chain);
  const ComplexityJudge judge = sample_judge(layout, rule);
  const auto score = [&](const Choice& choice) {
    const LinearMap moved = choice.placement.map();
    double shares = 0;
    std::size_t begin = 0;
    for (const std::size_t end : sample.ends) {
      const auto words = std::span(sample.words).first(end).subspan(begin);
      shares += accepted(words, moved, choice.translation, judge) / static_cast<double>(end);
      begin = end;
    }
    return shares;
  };
  Choice choice{unmoved(bits), translations.front()};
  if (rule.rule != ComplexityRule::None) {
    choice = best_choice(std::move(choice), translations, tries, score, random);
  }
  const LinearMap moved = choice.placement.map();
  RotationCodeParts parts;
  parts.bits = bits;
  for (const Codeword word : chain.levels.back().code.basis()) parts.basis.push_back(moved(word));
  parts.translation = moved(choice.translation);
  for (const CodeChain::Level& level : chain.levels) {
    parts.levels.push_back({level.code.dimension(), 1});
  }
  return parts;
}

std::vector<Codeword> place_tags(const std::vector<Codeword>& tags, const Layout& layout,
                                 const Complexity& rule, int tries, RandomChoice& random) {
  const int bits = layout.bits();
  // Words that a quarter turn does not change: extensions of the code of 0 alone.
  const std::vector<Codeword> translations =
      sums_of(one_step_extensions(TurnCode(bits), nullptr), kMostSample);
  const auto sample = std::span(tags).first(std::min(tags.size(), kMostSample));
  const ComplexityJudge judge = sample_judge(layout, rule);
  Choice choice{unmoved(bits), 0};
  if (rule.rule != ComplexityRule::None) {
    const auto score = [&](const Choice& tried) {
      return accepted(sample, tried.placement.map(), tried.translation, judge);
    };
    choice = best_choice(std::move(choice), translations, tries, score, random);
  }
  const LinearMap moved = choice.placement.map();
  std::vector<Codeword> placed;
  for (const Codeword tag : tags) placed.push_back(moved(tag ^ choice.translation));
  return placed;
}

}  // namespace tagmint::codec
