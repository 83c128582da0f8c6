#pragma once

#include <string>

namespace tagmint::draw {

/// Appends a number as the text formats of drawings take it: no exponent, no needless zeros,
/// rounded to `digits` (0..9) after the point.
void append_number(std::string& out, double value, int digits);

/// The same as a text of its own.
std::string number_text(double value, int digits);

}  // namespace tagmint::draw
