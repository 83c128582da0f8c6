#pragma once

#include <string>

#include "draw/canvas.h"

namespace tagmint::draw {

/// Where a text stands against its x.
enum class TextAlign { Left, Centre, Right };

/// How a text looks.
struct TextStyle {
  double size_mm = 3.0;  ///< of the font: from line to line
  Ink ink = {.gray = 0.0, .role = Role::Note};
  TextAlign align = TextAlign::Left;
};

/// Writes one line in the canvas's typeface, smaller where it would be wider than allowed. Throws
/// std::invalid_argument when the text is not UTF-8.
///   x_mm, baseline_mm   where the text starts, is centred or ends; its baseline
///   most_mm             largest width, > 0
void draw_text(Canvas& canvas, const std::string& text, double x_mm, double baseline_mm,
               double most_mm, const TextStyle& style);

}  // namespace tagmint::draw
