#pragma once

#include "plot/figure.h"
#include "plot/pen.h"

namespace tagmint::plot {

/// Draws a panel into a box: title, axes with ticks and labels, marks, series.
void draw_panel(Pen& pen, const Panel& panel, const Box& box);

}  // namespace tagmint::plot
