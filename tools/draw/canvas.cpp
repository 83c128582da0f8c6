#include "draw/canvas.h"

namespace tagmint::draw {

void Canvas::show_text(const TextLine& line) {
  double x = line.x_mm;
  for (const Glyph* glyph : line.glyphs) {
    if (!glyph->outline.empty())
      fill(glyph->outline, {x, line.baseline_mm, line.size_mm}, line.ink);
    x += line.size_mm * glyph->advance;
  }
}

}  // namespace tagmint::draw
