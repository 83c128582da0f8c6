#include "search/sieve_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "tagmint/codec/codeword.h"

namespace tagmint::codec {
namespace {

// Costs in comparisons of one vector of words with one code, as measured with AVX-512.
constexpr double kGatherCell = 3;    // one cell's codes copied
constexpr double kGatherWide = 0.2;  // one code of a coarse cell copied
constexpr double kBeginTier = 60;    // one call of the kernels and what surrounds it
constexpr double kBeginGroup = 60;
constexpr double kFillVector = 3;  // words of a group made, those left pooled
constexpr double kLanesOfUpper = 16;
constexpr double kLanesOfWord = 8;

/// Chances with words and codes taken as random: of b bits, how often exactly or at most w differ.
class Differing {
 public:
  Differing() {
    for (int bits = 0; bits <= kMaxBits; ++bits) {
      exactly_[bits][0] = std::ldexp(1.0, -bits);
      for (int w = 1; w <= bits; ++w) {
        exactly_[bits][w] = exactly_[bits][w - 1] * (bits - w + 1) / w;
      }
      at_most_[bits][0] = exactly_[bits][0];
      for (int w = 1; w <= kMaxBits; ++w)
        at_most_[bits][w] = at_most_[bits][w - 1] + exactly_[bits][w];
    }
  }
  double exactly(int bits, int w) const { return exactly_[bits][w]; }
  double at_most(int bits, int w) const { return w < 0 ? 0 : at_most_[bits][w]; }

 private:
  std::array<std::array<double, kMaxBits + 1>, kMaxBits + 1> exactly_{};
  std::array<std::array<double, kMaxBits + 1>, kMaxBits + 1> at_most_{};
};

/// The words of one group on their way through the tiers.
struct Sifting {
  double words = 0;
  double cost = 0;

  /// Compares the words with `codes`, of which each word is near to `covers` on average.
  void compare(double codes, double covers, double lanes) {
    // A word is compared until it is excluded: (1 - e^-covers) / covers of the codes on average.
    const double asked = covers > 1e-9 ? -std::expm1(-covers) / covers : 1;
    const double vectors = std::max(words / lanes, std::min(words, 1.0));
    cost += codes * asked * vectors;
    words *= std::exp(-covers);
  }
};

struct Problem {
  int bits;
  int min_hamming;
  double turns;
  double stretch;
};

/// Work for a stretch under `plan`. Codes near in the fine bits are near in the coarse ones too: a
/// coarse tier counts only those that the fine tiers have left out.
double work(const Problem& problem, const SievePlan& plan, const Differing& differing) {
  const auto [bits, min_hamming, turns, stretch] = problem;
  const bool grouped = bits - plan.fine_bits <= 32;
  const double groups = std::ldexp(1.0, plan.fine_bits);
  const double coarse_groups = std::ldexp(1.0, plan.coarse_bits);
  Sifting pool{.words = stretch / coarse_groups};
  double fine_cost = 0;
  if (grouped) {
    Sifting group{.words = stretch / groups};
    group.cost = kBeginGroup + kFillVector * std::ceil(group.words / kLanesOfUpper);
    for (int d = 0; d <= std::min({plan.fine_weight, plan.fine_bits, min_hamming - 1}); ++d) {
      const double codes = turns * differing.exactly(plan.fine_bits, d);
      group.cost += kBeginTier + kGatherCell * groups * differing.exactly(plan.fine_bits, d);
      group.compare(codes, codes * differing.at_most(bits - plan.fine_bits, min_hamming - 1 - d),
                    kLanesOfUpper);
    }
    fine_cost = group.cost * groups;
    pool.words = group.words * groups / coarse_groups;
  }
  const int middle = plan.fine_bits - plan.coarse_bits;
  double last_covers = 0;
  for (int d = 0; d <= plan.coarse_bits; ++d) {
    const double codes = turns * differing.exactly(plan.coarse_bits, d);
    double covers = 0;
    for (int m = grouped ? std::max(0, plan.fine_weight + 1 - d) : 0; m <= middle; ++m) {
      covers += codes * differing.exactly(middle, m) *
                differing.at_most(bits - plan.fine_bits, min_hamming - 1 - d - m);
    }
    if (d > plan.coarse_weight) {
      last_covers += covers;
    } else {
      pool.cost += kBeginTier + kGatherWide * codes;
      pool.compare(codes, covers, kLanesOfWord);
    }
  }
  pool.compare(turns, last_covers, kLanesOfWord);
  return fine_cost + pool.cost * coarse_groups;
}

}  // namespace

SievePlan plan_sieve(int bits, int min_hamming, std::size_t turns, std::uint64_t stretch) {
  static const Differing differing;
  const Problem problem{bits, min_hamming, static_cast<double>(turns),
                        static_cast<double>(stretch)};
  SievePlan best;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const SievePlan& plan) {
    const double cost = work(problem, plan, differing);
    if (cost < least) {
      least = cost;
      best = plan;
    }
  };
  const int most_fine = std::min({bits, 24, static_cast<int>(std::log2(problem.stretch + 1))});
  for (int fine = 0; fine <= most_fine; ++fine) {
    const int most_weight = bits - fine <= 32 ? 4 : 0;
    for (int weight = 0; weight <= most_weight; ++weight) {
      const int least_coarse = bits - fine <= 32 ? 0 : fine;
      for (int coarse = least_coarse; coarse <= fine; ++coarse) {
        for (int coarse_weight = 0; coarse_weight <= 4; ++coarse_weight) {
          consider({fine, weight, coarse, coarse_weight});
        }
      }
    }
  }
  return best;
}

}  // namespace tagmint::codec
