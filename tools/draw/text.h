#pragma once

#include <cairo.h>

#include <string>

namespace tagmint::draw {

/// Where a text stands against its x.
enum class TextAlign { Left, Centre, Right };

/// How a text looks.
struct TextStyle {
  double size_mm = 3.0;  ///< of the font: from line to line
  double gray = 0.0;     ///< 0 = black, 1 = white
  TextAlign align = TextAlign::Left;
};

/// Writes one line in the system's sans-serif font, smaller where it would be wider than allowed.
///   x_mm, baseline_mm   where the text starts, is centred or ends; its baseline
///   most_mm             largest width, > 0
void draw_text(cairo_t* context, const std::string& text, double x_mm, double baseline_mm,
               double most_mm, const TextStyle& style);

}  // namespace tagmint::draw
