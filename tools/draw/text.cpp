#include "draw/text.h"

#include <algorithm>

namespace tagmint::draw {
namespace {

/// The font at a size, without fitting to pixels: widths are the same in every kind of file.
void set_font(cairo_t* context, double size_mm) {
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, size_mm);
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
}

double width_of(cairo_t* context, const std::string& text) {
  cairo_text_extents_t extents = {};
  cairo_text_extents(context, text.c_str(), &extents);
  return extents.x_advance;
}

}  // namespace

void draw_text(cairo_t* context, const std::string& text, double x_mm, double baseline_mm,
               double most_mm, const TextStyle& style) {
  set_font(context, style.size_mm);
  double width = width_of(context, text);
  if (width > most_mm) {
    set_font(context, style.size_mm * most_mm / width);
    width = most_mm;
  }
  const double share =
      style.align == TextAlign::Left ? 0.0 : (style.align == TextAlign::Centre ? 0.5 : 1.0);
  cairo_set_source_rgb(context, style.gray, style.gray, style.gray);
  cairo_move_to(context, x_mm - share * width, baseline_mm);
  cairo_show_text(context, text.c_str());
  cairo_new_path(context);
}

}  // namespace tagmint::draw
