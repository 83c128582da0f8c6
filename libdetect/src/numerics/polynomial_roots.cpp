#include "numerics/polynomial_roots.h"

namespace tagmint::detect {
namespace {

/// The root in [low, high], at whose ends the polynomial has different signs, to the last bit.
double bisect(std::span<const double> coefficients, double low, double high) {
  const bool positive_at_low = polynomial_at(coefficients, low) > 0;
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return middle;
    ((polynomial_at(coefficients, middle) > 0) == positive_at_low ? low : high) = middle;
  }
}

}  // namespace

double polynomial_at(std::span<const double> coefficients, double x) {
  double value = 0;
  for (std::size_t i = coefficients.size(); i-- > 0;) value = value * x + coefficients[i];
  return value;
}

std::vector<double> polynomial_sign_changes(std::span<const double> coefficients, double low,
                                            double high) {
  if (coefficients.size() < 2) return {};
  std::vector<double> derivative;
  for (std::size_t i = 1; i < coefficients.size(); ++i) {
    derivative.push_back(static_cast<double>(i) * coefficients[i]);
  }
  std::vector<double> ends = polynomial_sign_changes(derivative, low, high);
  ends.push_back(high);
  std::vector<double> changes;
  double begin = low;
  for (const double end : ends) {
    const bool before = polynomial_at(coefficients, begin) > 0;
    const bool after = polynomial_at(coefficients, end) > 0;
    if (before != after) changes.push_back(bisect(coefficients, begin, end));
    begin = end;
  }
  return changes;
}

}  // namespace tagmint::detect
