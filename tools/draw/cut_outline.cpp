#include "draw/cut_outline.h"

#include <algorithm>

namespace tagmint::draw {
namespace {

/// How far the corner of a square must stay from an arc's square of the same middle: the arc of
/// radius r in a corner comes (1 - 1/sqrt 2) r nearer along each axis than the corner it replaces.
constexpr double kArcLoss = 0.29289321881345254;

}  // namespace

Path cut_outline(const PlacedTag& tag, const codec::Layout& layout, CutShape shape, double gap_mm) {
  // The line's inner side is half a line from the slot, so that rounding leaves it outside.
  const double away = kCutLineMm;
  const Box& slot = tag.slot;
  Path path;
  switch (shape) {
    case CutShape::Square:
      path.add_rectangle(slot.x_mm - away, slot.y_mm - away, slot.width_mm + 2 * away,
                         slot.height_mm + 2 * away);
      break;
    case CutShape::Rounded: {
      // The square of the arcs reaches at most a line's width short of the middle of the gap.
      const double room = std::max(0.0, gap_mm / 2 - away - kCutLineMm);
      const double radius = std::min(room / kArcLoss, slot.width_mm / 6);
      const double reach = away + kArcLoss * radius;
      path.add_rounded_rectangle(slot.x_mm - reach, slot.y_mm - reach, slot.width_mm + 2 * reach,
                                 slot.height_mm + 2 * reach, radius);
      break;
    }
    case CutShape::Circle: {
      const double cell = tag.outer.width_mm / layout.width();
      const double radius = radius_cells(layout) * cell + tag.quiet_mm + away;
      path.add_circle(tag.outer.x_mm + tag.outer.width_mm / 2,
                      tag.outer.y_mm + tag.outer.height_mm / 2, radius);
      break;
    }
  }
  return path;
}

}  // namespace tagmint::draw
