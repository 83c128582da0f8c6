#include "search/dense_simplex.h"

#include <numeric>
#include <optional>
#include <utility>

namespace tagmint::codec {

namespace {

/// What is nearer to zero than this counts as zero.
constexpr Quad kTiny = 1e-24L;

/// The program as equations that give the basic variables (one a row) from the others (one a
/// column), which are zero: basic = limits - matrix * others; gain = const + gains * others.
/// Variable v < columns is x_v; variable columns + r is what row r leaves of its limit.
class Dictionary {
 public:
  explicit Dictionary(LinearProgram&& program)
      : program_(std::move(program)),
        others_(program_.gains.size()),
        basic_(program_.limits.size()) {
    std::iota(others_.begin(), others_.end(), std::size_t{0});
    std::iota(basic_.begin(), basic_.end(), others_.size());
  }

  /// The column to raise from zero: the one with the largest gain, or, where steps gained nothing,
  /// that of the lowest variable that gains, which never leads back (Bland's rule).
  std::optional<std::size_t> entering(bool lowest_variable) const {
    std::optional<std::size_t> best;
    for (std::size_t column = 0; column < others_.size(); ++column) {
      if (program_.gains[column] <= kTiny) continue;
      const bool better =
          !best || (lowest_variable ? others_[column] < others_[*best]
                                    : program_.gains[column] > program_.gains[*best]);
      if (better) best = column;
    }
    return best;
  }

  /// The row whose basic variable reaches zero first when that column is raised; of several the one
  /// with the lowest variable.
  std::optional<std::size_t> leaving(std::size_t column) const {
    std::optional<std::size_t> best;
    Quad best_reach = 0;
    for (std::size_t row = 0; row < basic_.size(); ++row) {
      const Quad slope = program_.matrix[row][column];
      if (slope <= kTiny) continue;
      const Quad reach = program_.limits[row] / slope;
      if (!best || reach < best_reach || (reach == best_reach && basic_[row] < basic_[*best])) {
        best = row;
        best_reach = reach;
      }
    }
    return best;
  }

  /// Exchanges the roles of a basic and another variable; returns how much was gained.
  Quad exchange(std::size_t row, std::size_t column) {
    std::vector<Quad>& pivot_row = program_.matrix[row];
    const Quad pivot = pivot_row[column];
    pivot_row[column] = 1;
    for (Quad& entry : pivot_row) entry /= pivot;
    program_.limits[row] /= pivot;
    for (std::size_t other = 0; other < basic_.size(); ++other) {
      if (other == row) continue;
      const Quad factor = std::exchange(program_.matrix[other][column], 0);
      if (factor == 0) continue;
      subtract(program_.matrix[other], factor, pivot_row);
      program_.limits[other] -= factor * program_.limits[row];
      if (program_.limits[other] < 0) program_.limits[other] = 0;
    }
    const Quad gain = std::exchange(program_.gains[column], 0);
    subtract(program_.gains, gain, pivot_row);
    std::swap(basic_[row], others_[column]);
    return gain * program_.limits[row];
  }

  /// What a unit more of each row's limit would gain.
  std::vector<Quad> prices() const {
    std::vector<Quad> prices(basic_.size(), 0);
    for (std::size_t column = 0; column < others_.size(); ++column) {
      if (others_[column] < others_.size()) continue;
      const Quad price = -program_.gains[column];
      prices[others_[column] - others_.size()] = price > 0 ? price : Quad{0};
    }
    return prices;
  }

 private:
  static void subtract(std::vector<Quad>& from, Quad factor, const std::vector<Quad>& row) {
    for (std::size_t i = 0; i < from.size(); ++i) from[i] -= factor * row[i];
  }

  LinearProgram program_;
  std::vector<std::size_t> others_;  ///< variable of each column
  std::vector<std::size_t> basic_;   ///< variable of each row
};

}  // namespace

std::vector<Quad> dual_prices(LinearProgram program) {
  const std::size_t most_steps = 50 * (program.limits.size() + program.gains.size());
  Dictionary dictionary(std::move(program));
  bool stalled = false;
  for (std::size_t step = 0; step < most_steps; ++step) {
    const std::optional<std::size_t> column = dictionary.entering(stalled);
    if (!column) break;
    const std::optional<std::size_t> row = dictionary.leaving(*column);
    if (!row) break;
    stalled = dictionary.exchange(*row, *column) <= kTiny;
  }
  return dictionary.prices();
}

}  // namespace tagmint::codec
