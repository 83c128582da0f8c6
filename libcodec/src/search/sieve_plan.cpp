#include "search/sieve_plan.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "tagmint/codec/codeword.h"

namespace tagmint::codec {
namespace {

// Costs in comparisons of one vector of words with one code, as measured with AVX-512.
constexpr double kGatherCell = 2.5;      // codes of a cell copied
constexpr double kGatherCoarseCell = 8;  // the same for a coarse cell, but its codes:
constexpr double kGatherCoarseCode = 0.2;
constexpr double kBeginTier = 40;  // calls of the kernels and what surrounds them
constexpr double kBeginGroup = 60;
constexpr double kFillVector = 3;  // words of a group made, those left pooled
/// Codes cover words less evenly than chance would: the words left are those of a smaller number.
constexpr double kEvenness = 0.8;
constexpr double kLanesOfUpper = 16;
constexpr double kLanesOfWord = 8;

// The plans considered: groups of 16 to 65536 words.
constexpr int kLogFewestWords = 4;
constexpr int kLogMostWords = 16;
constexpr int kMostFineBits = 24;
constexpr int kMostWeight = 4;

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

/// Words on their way through the tiers of codes that they are compared with.
struct Sifting {
  double words = 0;
  double cost = 0;

  /// Compares the words with `codes`, of which each word is near to `covers` on average.
  void compare(double codes, double covers, double lanes) {
    // A word is compared until it is excluded: (1 - e^-covers) / covers of the codes on average.
    // Lanes stay empty at the end of the words.
    covers *= kEvenness;
    const double asked = covers > 1e-9 ? -std::expm1(-covers) / covers : 1;
    const double vectors = words * asked / lanes;
    cost += codes * (vectors + 0.4 * std::min(vectors, 1.0));
    words *= std::exp(-covers);
  }
};

/// Looks for the cheapest plan. Groups and coarse groups follow each other, so the work on groups
/// is the same for all plans that differ in the coarse part alone.
class Planner {
 public:
  Planner(int bits, int min_hamming, std::size_t turns, std::uint64_t stretch)
      : bits_(bits),
        min_hamming_(min_hamming),
        turns_(static_cast<double>(turns)),
        stretch_(static_cast<double>(stretch)) {}

  /// Considers all plans that begin with these two; fine_weight -1: no groups but the coarse ones.
  void consider(int fine_bits, int fine_weight) {
    const double groups = std::ldexp(1.0, fine_bits);
    Sifting group{.words = stretch_ / groups};
    for (int d = 0; d <= std::min({fine_weight, fine_bits, min_hamming_ - 1}); ++d) {
      const double cells = groups * differing().exactly(fine_bits, d);
      const double codes = turns_ / groups * cells;
      group.cost += kBeginTier + kGatherCell * cells;
      group.compare(codes, codes * upper_covers(fine_bits, d), kLanesOfUpper);
    }
    if (fine_weight >= 0) {
      group.cost += kBeginGroup + kFillVector * std::ceil(stretch_ / groups / kLanesOfUpper);
    }
    if (group.cost * groups >= least_) return;
    SievePlan plan{.fine_bits = fine_bits, .fine_weight = std::max(fine_weight, 0)};
    plan.coarse_bits = fine_weight >= 0 ? 0 : fine_bits;
    for (; plan.coarse_bits <= fine_bits; ++plan.coarse_bits) {
      consider_coarse(plan, fine_weight, group);
    }
  }

  const SievePlan& best() const { return best_; }

 private:
  /// Considers plan.coarse_bits with each weight, behind the work on one group.
  void consider_coarse(SievePlan plan, int fine_weight, const Sifting& group) {
    const double coarse_groups = std::ldexp(1.0, plan.coarse_bits);
    const double groups_in_one = std::ldexp(1.0, plan.fine_bits - plan.coarse_bits);
    double covers_left = 0;
    for (int d = fine_weight + 1; d <= plan.fine_bits; ++d) {
      covers_left +=
          turns_ * differing().exactly(plan.fine_bits, d) * upper_covers(plan.fine_bits, d);
    }
    Sifting pool{group.words * groups_in_one, group.cost * groups_in_one};
    const int most_weight = std::min(kMostWeight, plan.coarse_bits);
    for (int d = 0; d <= most_weight; ++d) {
      const double cells = coarse_groups * differing().exactly(plan.coarse_bits, d);
      const double codes = turns_ / coarse_groups * cells;
      const double covers = codes * coarse_covers(plan, fine_weight, d);
      pool.cost += kBeginTier + kGatherCoarseCell * cells + kGatherCoarseCode * codes;
      pool.compare(codes, covers, kLanesOfWord);
      covers_left = std::max(0.0, covers_left - covers);
      Sifting with_all = pool;
      with_all.compare(turns_, covers_left, kLanesOfWord);
      if (with_all.cost * coarse_groups < least_) {
        least_ = with_all.cost * coarse_groups;
        best_ = plan;
        best_.coarse_weight = d;
      }
    }
  }

  /// Chance that a word is near to a code that differs in d fine bits.
  double upper_covers(int fine_bits, int d) const {
    return differing().at_most(bits_ - fine_bits, min_hamming_ - 1 - d);
  }

  /// The same for a code that differs in d coarse bits; those near in the fine bits, which the
  /// group has been compared with, do not count.
  double coarse_covers(const SievePlan& plan, int fine_weight, int d) const {
    const int middle = plan.fine_bits - plan.coarse_bits;
    double covers = 0;
    for (int m = std::max(0, fine_weight + 1 - d); m <= middle; ++m) {
      covers += differing().exactly(middle, m) * upper_covers(plan.fine_bits, d + m);
    }
    return covers;
  }

  static const Differing& differing() {
    static const Differing table;
    return table;
  }

  int bits_;
  int min_hamming_;
  double turns_;
  double stretch_;
  SievePlan best_;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace

SievePlan plan_sieve(int bits, int min_hamming, std::size_t turns, std::uint64_t stretch) {
  Planner planner(bits, min_hamming, turns, stretch);
  const int log_stretch = std::bit_width(std::max<std::uint64_t>(stretch, 1)) - 1;
  const int least_fine = std::min(bits, std::max(0, log_stretch - kLogMostWords));
  const int most_fine = std::min({bits, kMostFineBits, std::max(0, log_stretch - kLogFewestWords)});
  for (int fine = least_fine; fine <= std::max(least_fine, most_fine); ++fine) {
    if (bits - fine > 32) {
      planner.consider(fine, -1);
    } else {
      for (int weight = 0; weight <= kMostWeight; ++weight) planner.consider(fine, weight);
    }
  }
  return planner.best();
}

}  // namespace tagmint::codec
