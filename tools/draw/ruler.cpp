#include "draw/ruler.h"

#include <fmt/format.h>

#include <algorithm>

#include "draw/text.h"

namespace tagmint::draw {
namespace {

constexpr double kLineMm = 0.15;
constexpr double kTextMm = 2.4;
constexpr int kLongestMm = 150;
constexpr int kWantedMm = 100;
// From the ruler's line to the baselines of its numbers and of what it says.
constexpr double kNumbersMm = 6.2;
constexpr double kCallMm = 9.4;
constexpr double kCallRoomMm = 20.0;     // in which it is still large enough to be read
constexpr double kUprightCallMm = 12.0;  // that it takes below an upright ruler

/// Turns the ruler: lengths along it and away from its line become places on the page.
class RulerFrame {
 public:
  RulerFrame(const Box& box, RulerPlace place)
      : box_(box), upright_(place == RulerPlace::Upright) {}
  PathPoint at(double along, double away) const {
    // Half a line and half a number stick out at both ends.
    return upright_ ? PathPoint{box_.x_mm + away, box_.y_mm + kTextMm + along}
                    : PathPoint{box_.x_mm + kTextMm + along, box_.y_mm + away};
  }
  bool upright() const { return upright_; }

 private:
  Box box_;
  bool upright_;
};

void add_tick(Path& path, const RulerFrame& frame, double along, double depth) {
  const PathPoint from = frame.at(along, 0);
  const PathPoint to = frame.at(along, depth);
  path.add_line(from.x, from.y, to.x, to.y);
}

}  // namespace

int ruler_length_mm(double room_mm) {
  const int whole_cm = static_cast<int>(std::max(0.0, (room_mm - 2 * kTextMm) / 10));
  return std::min(kLongestMm, 10 * whole_cm);
}

RulerPlace ruler_place(const Box& area) {
  if (ruler_length_mm(area.width_mm) >= kWantedMm) return RulerPlace::Lying;
  if (ruler_length_mm(area.height_mm - kUprightCallMm) >= kWantedMm) return RulerPlace::Upright;
  return ruler_length_mm(area.width_mm) > 0 ? RulerPlace::Lying : RulerPlace::None;
}

void draw_ruler(Canvas& canvas, const Box& box, RulerPlace place, double gray) {
  if (place == RulerPlace::None) return;
  const RulerFrame frame(box, place);
  const int length =
      ruler_length_mm(frame.upright() ? box.height_mm - kUprightCallMm : box.width_mm);
  if (length == 0) return;
  Path lines;
  for (int mm = 0; mm <= length; ++mm) {
    add_tick(lines, frame, mm, mm % 10 == 0 ? 3.5 : (mm % 5 == 0 ? 2.6 : 1.6));
  }
  const PathPoint start = frame.at(-kLineMm / 2, 0);
  const PathPoint end = frame.at(length + kLineMm / 2, 0);
  lines.add_line(start.x, start.y, end.x, end.y);
  const Ink ink{.gray = gray, .role = Role::Note};
  canvas.stroke(lines, {}, {.width_mm = kLineMm, .ink = ink});

  const TextStyle numbers{.size_mm = kTextMm, .ink = ink, .align = TextAlign::Centre};
  for (int mm = 0; mm <= length; mm += 10) {
    // Beside an upright ruler, numbers lie as well: their middle is on the tick.
    const PathPoint at =
        frame.upright() ? frame.at(mm + 0.36 * kTextMm, kNumbersMm) : frame.at(mm, kNumbersMm);
    draw_text(canvas, fmt::format("{}", mm), at.x, at.y, 10.0, numbers);
  }
  const TextStyle style{.size_mm = kTextMm, .ink = ink, .align = TextAlign::Left};
  const std::string end_text = fmt::format("{} mm", length);
  if (frame.upright()) {
    double below = length + 2 * kTextMm;
    for (const std::string& word : {std::string("measure"), std::string("me:"), end_text}) {
      const PathPoint at = frame.at(below, 0);
      draw_text(canvas, word, at.x, at.y, kRulerDepthMm, style);
      below += 1.2 * kTextMm;
    }
  } else {
    // Beside the ruler's end, or below it where there is no room.
    const double room = box.width_mm - length - 4 * kTextMm;
    const bool beside = room >= kCallRoomMm;
    const PathPoint at = beside ? frame.at(length + 2 * kTextMm, 0.36 * kTextMm + kNumbersMm / 2)
                                : frame.at(0, kCallMm);
    draw_text(canvas, "measure me: " + end_text, at.x, at.y, beside ? room : length, style);
  }
}

}  // namespace tagmint::draw
