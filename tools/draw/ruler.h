#pragma once

#include "draw/canvas.h"

namespace tagmint::draw {

/// Draws a ruler of whole centimetres to measure a print with, at most 100 mm, as long as fits. It
/// takes kRulerHeightMm (sheet_decor.h).
///   x_mm, y_mm   its left end and upper side
///   room_mm      width that it may take; nothing is drawn where a centimetre does not fit
void draw_ruler(Canvas& canvas, double x_mm, double y_mm, double room_mm, double gray);

}  // namespace tagmint::draw
