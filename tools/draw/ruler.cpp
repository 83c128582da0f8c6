#include "draw/ruler.h"

#include <fmt/format.h>

#include <algorithm>

#include "draw/text.h"

namespace tagmint::draw {

void draw_ruler(Canvas& canvas, double x_mm, double y_mm, double room_mm, double gray) {
  constexpr double kLineMm = 0.15;
  constexpr double kTextMm = 2.4;
  constexpr int kLongestCm = 10;
  // Half a line and half a number stick out at both ends.
  const int length_cm = std::min(kLongestCm, static_cast<int>((room_mm - 2 * kTextMm) / 10));
  if (length_cm < 1) return;
  const double left = x_mm + kTextMm;
  Path lines;
  for (int mm = 0; mm <= 10 * length_cm; ++mm) {
    const double height = mm % 10 == 0 ? 3.5 : (mm % 5 == 0 ? 2.6 : 1.6);
    lines.add_line(left + mm, y_mm, left + mm, y_mm + height);
  }
  lines.add_line(left - kLineMm / 2, y_mm, left + 10 * length_cm + kLineMm / 2, y_mm);
  const Ink ink{.gray = gray, .role = Role::Note};
  canvas.stroke(lines, {}, {.width_mm = kLineMm, .ink = ink});
  for (int cm = 0; cm <= length_cm; ++cm) {
    const std::string number = cm < length_cm ? fmt::format("{}", 10 * cm)  //
                                              : fmt::format("{} mm", 10 * cm);
    draw_text(canvas, number, left + 10 * cm, y_mm + 6.2, 10.0,
              {.size_mm = kTextMm, .ink = ink, .align = TextAlign::Centre});
  }
}

}  // namespace tagmint::draw
