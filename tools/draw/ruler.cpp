#include "draw/ruler.h"

#include <fmt/format.h>

#include <algorithm>

#include "draw/text.h"

namespace tagmint::draw {

void draw_ruler(cairo_t* context, double x_mm, double y_mm, double room_mm, double gray) {
  constexpr double kLineMm = 0.15;
  constexpr double kTextMm = 2.4;
  constexpr int kLongestCm = 10;
  // Half a line and half a number stick out at both ends.
  const int length_cm = std::min(kLongestCm, static_cast<int>((room_mm - 2 * kTextMm) / 10));
  if (length_cm < 1) return;
  const double left = x_mm + kTextMm;
  for (int mm = 0; mm <= 10 * length_cm; ++mm) {
    const double height = mm % 10 == 0 ? 3.5 : (mm % 5 == 0 ? 2.6 : 1.6);
    cairo_move_to(context, left + mm, y_mm);
    cairo_line_to(context, left + mm, y_mm + height);
  }
  cairo_move_to(context, left - kLineMm / 2, y_mm);
  cairo_line_to(context, left + 10 * length_cm + kLineMm / 2, y_mm);
  cairo_set_line_width(context, kLineMm);
  cairo_set_source_rgb(context, gray, gray, gray);
  cairo_stroke(context);
  for (int cm = 0; cm <= length_cm; ++cm) {
    const std::string number = cm < length_cm ? fmt::format("{}", 10 * cm)  //
                                              : fmt::format("{} mm", 10 * cm);
    draw_text(context, number, left + 10 * cm, y_mm + 6.2, 10.0,
              {.size_mm = kTextMm, .gray = gray, .align = TextAlign::Centre});
  }
}

}  // namespace tagmint::draw
