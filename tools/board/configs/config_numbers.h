#pragma once

#include <string>

namespace tagmint::board {

/// A number with up to twelve decimals and at least one, "0.0264", "1.0", so that every reader
/// takes it for a number with a fraction; never "-0.0".
std::string decimal(double value);

/// A length in mm as metres; exact to 1e-12 m.
std::string metres(double length_mm);

/// The turn of a tag about the axis towards the viewer, as the two parts of a unit quaternion that
/// are not zero. A tag turned clockwise as seen turns by a negative angle about that axis.
struct HalfTurn {
  double w = 1.0;     ///< cosine of half the angle, >= 0
  double axis = 0.0;  ///< its sine, along the axis towards the viewer
};
HalfTurn half_turn(double clockwise_deg);

}  // namespace tagmint::board
