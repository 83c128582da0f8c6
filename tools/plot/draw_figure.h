#pragma once

#include <string>

#include "plot/figure.h"

namespace tagmint::plot {

/// The figure as the content of an SVG or a PNG file, drawn by Cairo from the same commands, white
/// ground, in colours that stay apart in grey. Text in the SVG is outlines, so it looks alike
/// everywhere; <title> and <desc> say in words what is shown: panels, axes and series.
/// The same figure gives the same bytes, whatever was drawn before.
///   errors   std::invalid_argument for a figure without panels or an unknown style;
///            codec::OutputError when Cairo fails
std::string figure_svg(const Figure& figure);
/// `scale`: pixels of the file for each px of the SVG, > 0.
std::string figure_png(const Figure& figure, double scale = 1.5);

/// What <desc> says: one sentence a panel.
std::string describe(const Figure& figure);

}  // namespace tagmint::plot
