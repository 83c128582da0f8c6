#include "draw/text.h"

#include <algorithm>

namespace tagmint::draw {

void draw_text(Canvas& canvas, const std::string& text, double x_mm, double baseline_mm,
               double most_mm, const TextStyle& style) {
  TextLine line{.text = text,
                .glyphs = canvas.typeface().glyphs(text),
                .x_mm = x_mm,
                .baseline_mm = baseline_mm,
                .size_mm = style.size_mm,
                .ink = style.ink};
  const double natural = width_of(line.glyphs);
  if (natural <= 0) return;
  line.size_mm = std::min(line.size_mm, most_mm / natural);
  const double share =
      style.align == TextAlign::Left ? 0.0 : (style.align == TextAlign::Centre ? 0.5 : 1.0);
  line.x_mm -= share * natural * line.size_mm;
  canvas.show_text(line);
}

}  // namespace tagmint::draw
