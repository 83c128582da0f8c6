#pragma once

#include <span>
#include <vector>

namespace tagmint::detect {

/// c[0] + c[1] x + c[2] x^2 + ...
double polynomial_at(std::span<const double> coefficients, double x);

/// Places in [low, high], ascending, where the polynomial changes its sign. Between neighbouring
/// sign changes of the derivative a polynomial is monotone, so bisection finds each root there is.
/// Leading zeros do no harm; a double root, which only touches zero, is found twice or not at all.
///   cost     about 60 evaluations a root and degree
std::vector<double> polynomial_sign_changes(std::span<const double> coefficients, double low,
                                            double high);

}  // namespace tagmint::detect
