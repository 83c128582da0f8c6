#pragma once

#include "draw/canvas.h"
#include "draw/sheet_plan.h"

namespace tagmint::draw {

/// How a ruler stands on a page.
enum class RulerPlace { None, Lying, Upright };

/// Space that a ruler takes across its length: lines, numbers and "measure me".
inline constexpr double kRulerDepthMm = 10.5;

/// Length of the ruler for a side of that length, in mm: whole centimetres, at most 150 (as
/// callipers measure), 0 where not even one fits.
int ruler_length_mm(double room_mm);

/// Where a ruler of at least 100 mm has room within `area`: lying, else upright; where neither is
/// long enough, a shorter one lies.
RulerPlace ruler_place(const Box& area);

/// Draws a ruler to measure a print with, in the lower part of `box` (lying) or from its upper end
/// at its left (upright). Nothing is drawn where a centimetre does not fit.
void draw_ruler(Canvas& canvas, const Box& box, RulerPlace place, double gray);

}  // namespace tagmint::draw
