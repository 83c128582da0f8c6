#pragma once

#include <array>

namespace tagmint::scene {

/// The rotation that turns a tag about the camera's x axis, then its y axis, then its z axis:
/// row-major Rz * Ry * Rx. Of a tag that faced the camera upright, a positive x angle moves the
/// lower edge away, a positive y angle brings the right edge nearer, a positive z angle turns it
/// clockwise as seen.
///   degrees   the three angles
std::array<double, 9> rotation_from_angles(const std::array<double, 3>& degrees);

/// The matrix product a * b, row-major 3 x 3.
std::array<double, 9> multiply(const std::array<double, 9>& a, const std::array<double, 9>& b);

}  // namespace tagmint::scene
