#include "plot/pen.h"

#include <numbers>
#include <vector>

namespace tagmint::plot {
namespace {

constexpr double kMarkerRadius_px = 3.6;

/// Corners of a marker's outline, in radii from its middle.
std::vector<std::pair<double, double>> outline_of(Marker marker) {
  switch (marker) {
    case Marker::Square:
      return {{-0.85, -0.85}, {0.85, -0.85}, {0.85, 0.85}, {-0.85, 0.85}};
    case Marker::Triangle:
      return {{0, -1.15}, {1.05, 0.8}, {-1.05, 0.8}};
    case Marker::Down:
      return {{0, 1.15}, {1.05, -0.8}, {-1.05, -0.8}};
    case Marker::Diamond:
      return {{0, -1.25}, {1.05, 0}, {0, 1.25}, {-1.05, 0}};
    default:
      return {};
  }
}

}  // namespace

void Pen::font(double size_px, bool bold) {
  cairo_select_font_face(context_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_, size_px);
}

double Pen::text_width(const std::string& text, double size_px, bool bold) {
  font(size_px, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(context_, text.c_str(), &extents);
  return extents.x_advance;
}

void Pen::text(double x, double y, const std::string& text, double size_px, Align align,
               bool bold) {
  const double width = text_width(text, size_px, bold);
  const double back = align == Align::Left ? 0 : align == Align::Middle ? width / 2 : width;
  cairo_set_source_rgb(context_, 0.1, 0.1, 0.1);
  cairo_move_to(context_, x - back, y);
  cairo_show_text(context_, text.c_str());
  cairo_new_path(context_);
}

void Pen::turned_text(double x, double y, const std::string& text, double size_px) {
  cairo_save(context_);
  cairo_translate(context_, x, y);
  cairo_rotate(context_, -std::numbers::pi / 2);
  this->text(0, 0, text, size_px, Align::Middle);
  cairo_restore(context_);
}

void Pen::rule(double x0, double y0, double x1, double y1, double gray, double width_px) {
  cairo_set_source_rgb(context_, gray, gray, gray);
  cairo_set_line_width(context_, width_px);
  cairo_set_dash(context_, nullptr, 0, 0);
  cairo_move_to(context_, x0, y0);
  cairo_line_to(context_, x1, y1);
  cairo_stroke(context_);
}

void Pen::use(const Style& style) {
  cairo_set_source_rgb(context_, style.colour.red, style.colour.green, style.colour.blue);
}

void Pen::stroke(const Style& style) {
  use(style);
  cairo_set_line_width(context_, style.width_px);
  cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
  cairo_set_dash(context_, style.dashes.data(), static_cast<int>(style.dashes.size()), 0);
  cairo_stroke(context_);
  cairo_set_dash(context_, nullptr, 0, 0);
}

void Pen::marker(const Style& style, double x, double y, bool hollow) {
  const double r = kMarkerRadius_px;
  cairo_set_line_width(context_, 1.4);
  cairo_new_path(context_);
  if (style.marker == Marker::Cross || style.marker == Marker::Plus) {
    const double d = style.marker == Marker::Cross ? r * 0.85 : 0;
    const double l = style.marker == Marker::Cross ? r * 0.85 : r * 1.2;
    cairo_move_to(context_, x - l, y - d);
    cairo_line_to(context_, x + l, y + d);
    cairo_move_to(context_, x + (d > 0 ? d : 0), y - l);
    cairo_line_to(context_, x - (d > 0 ? d : 0), y + l);
    use(style);
    cairo_stroke(context_);
    return;
  }
  const auto outline = outline_of(style.marker);
  if (outline.empty()) {
    cairo_arc(context_, x, y, r * 0.95, 0, 2 * std::numbers::pi);
  }
  for (const auto& [dx, dy] : outline) cairo_line_to(context_, x + r * dx, y + r * dy);
  cairo_close_path(context_);
  if (hollow || style.marker == Marker::Ring) {
    cairo_set_source_rgb(context_, 1, 1, 1);
    cairo_fill_preserve(context_);
    use(style);
    cairo_stroke(context_);
  } else {
    use(style);
    cairo_fill(context_);
  }
}

void Pen::arrow_down(const Style& style, double x, double y) {
  constexpr double kLength_px = 15;
  constexpr double kHead_px = 3.5;
  use(style);
  cairo_set_line_width(context_, 1.4);
  cairo_move_to(context_, x, y + kMarkerRadius_px);
  cairo_line_to(context_, x, y + kLength_px);
  cairo_move_to(context_, x - kHead_px, y + kLength_px - kHead_px);
  cairo_line_to(context_, x, y + kLength_px);
  cairo_line_to(context_, x + kHead_px, y + kLength_px - kHead_px);
  cairo_stroke(context_);
}

}  // namespace tagmint::plot
