#pragma once

#include <string>
#include <vector>

#include "plot/figure.h"

namespace tagmint::plot {

/// A place of an axis that gets a line, and a number where there is room for one.
struct Tick {
  double value = 0;
  std::string text = {};  ///< empty = a line alone
};

/// From values of an axis to shares of its length.
class Scale {
 public:
  /// Fits the axis to the values that are drawn along it.
  ///   values   those of all series; where none can be drawn the axis goes from 0 (1) to 1 (10)
  Scale(const Axis& axis, const std::vector<double>& values);

  bool can_show(double value) const;
  /// Where the value is: 0 = beginning of the axis, 1 = its end; not cut off.
  double share(double value) const;
  double low() const { return low_; }
  double high() const { return high_; }
  const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  void fit_linear(const Axis& axis, double least, double most);
  void fit_logarithmic(const Axis& axis, double least, double most);
  void fit_categories(const Axis& axis);

  bool logarithmic_ = false;
  double low_ = 0;
  double high_ = 1;
  std::vector<Tick> ticks_;
};

}  // namespace tagmint::plot
