#include "search/paint_radius.h"

#include <cmath>
#include <limits>
#include <vector>

namespace tagmint::codec {
namespace {

// Measured, in cycles of one core with 512-bit vectors.
constexpr double kBallCost = 4;        // to find the rows of a ball
constexpr double kRowCost = 1.25;      // to paint a row
constexpr double kWordCost = 30;       // to find a word that is not painted
constexpr double kVectorCost = 2;      // to compare a word with a vector of entries
constexpr double kNarrowingCost = 6;   // of a vector of the list above
constexpr double kPartingCost = 10;    // of a vector by radius
constexpr double kVectorEntries = 16;  // entries in a vector
constexpr double kWorthNarrowing = 8;  // words, as OpenWordTree has it
constexpr double kTwigWords = 1u << TwigBits::kWordBits;

/// How many words of `bits` bits differ from a given one in d bits: [d], d = 0 .. bits.
std::vector<double> shells(int bits) {
  std::vector<double> sizes(bits + 1, 1);
  for (int d = 1; d <= bits; ++d) sizes[d] = sizes[d - 1] * (bits - d + 1) / d;
  return sizes;
}

/// Number of words within `radius`.
double ball(const std::vector<double>& shells, int radius) {
  double words = 0;
  for (int d = 0; d <= radius && d < static_cast<int>(shells.size()); ++d) words += shells[d];
  return words;
}

/// Logarithm of the share of a twig's words outside of a set of `words` words.
double log_outside(double words) { return std::log1p(-std::min(words / kTwigWords, 1 - 1e-12)); }

/// The expected work at a twig.
class TwigModel {
 public:
  TwigModel(int bits, int radius, std::size_t turns)
      : radius_(radius),
        turns_(static_cast<double>(turns)),
        // The root of a small tree is its own parent here.
        above_(shells(std::max(bits - TwigBits::kWordBits - 4, 0))),
        at_twig_(shells(bits - TwigBits::kWordBits)),
        rows_(shells(LeafPainter::kMostDepth)),
        row_(shells(TwigBits::kRowBits)),
        twig_(shells(TwigBits::kWordBits)) {}

  /// Cycles for a twig.
  double cost(const PaintPlan& plan) const {
    double cycles = 0;
    double unpainted = std::log(kTwigWords);  // logarithm of the number of words
    double open = unpainted;                  // and of those that no ball so far excludes
    double vectors = 0;                       // entries with that radius or more left
    double vectors_above = 0;
    for (int left = radius_; left >= 0; --left) {
      const double balls = expected(at_twig_, left);
      vectors += balls / kVectorEntries;
      vectors_above += expected(above_, left) / kVectorEntries;
      if (left >= plan.paint_radius) {
        double rows = 0, words = 0;
        for (int depth = 0; depth <= plan.depth(left); ++depth) {
          rows += rows_[depth];
          words += rows_[depth] * ball(row_, left - depth);
        }
        cycles += balls * (kBallCost + kRowCost * rows);
        unpainted += balls * log_outside(words);
      }
      if (left == plan.paint_radius) {
        cycles += vectors_above * kNarrowingCost + vectors * kPartingCost;
        // A word that an entry excludes meets it half way on average.
        cycles += std::exp(unpainted) * (kWordCost + kVectorCost * vectors / 2);
      }
      if (left < plan.paint_radius) {
        const double words = std::exp(open);
        cycles += std::min(words / kWorthNarrowing, 1.0) * vectors_above * kNarrowingCost;
        cycles += words * kVectorCost * balls / kVectorEntries;
      }
      open += balls * log_outside(ball(twig_, left));
    }
    return cycles;
  }

 private:
  /// Number of turns with a given radius left at a node.
  ///   decided   the shells of its decided bits
  double expected(const std::vector<double>& decided, int left) const {
    const std::size_t differing = radius_ - left;
    if (differing >= decided.size()) return 0;
    return std::ldexp(turns_ * decided[differing], 1 - static_cast<int>(decided.size()));
  }

  int radius_;
  double turns_;
  std::vector<double> above_, at_twig_;    // decided bits
  std::vector<double> rows_, row_, twig_;  // undecided ones
};

struct CostedPlan {
  PaintPlan plan;
  double cost = std::numeric_limits<double>::infinity();
};

CostedPlan best_plan(const TwigModel& model, int radius, int paint_radius) {
  CostedPlan best;
  for (int deep_radius = paint_radius; deep_radius <= radius + 1; ++deep_radius) {
    const PaintPlan plan{paint_radius, deep_radius};
    const double cost = model.cost(plan);
    if (cost < best.cost) best = {plan, cost};
  }
  return best;
}

}  // namespace

PaintPlan best_paint_plan(int bits, int radius, std::size_t turns, int paint_radius) {
  return best_plan(TwigModel(bits, radius, turns), radius, paint_radius).plan;
}

int best_paint_radius(int bits, int radius, std::size_t turns) {
  const TwigModel model(bits, radius, turns);
  CostedPlan best;
  for (int paint_radius = 0; paint_radius <= radius; ++paint_radius) {
    const CostedPlan candidate = best_plan(model, radius, paint_radius);
    if (candidate.cost < best.cost) best = candidate;
  }
  return best.plan.paint_radius;
}

}  // namespace tagmint::codec
