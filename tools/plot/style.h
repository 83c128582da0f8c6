#pragma once

#include <span>

#include "draw/colour.h"

namespace tagmint::plot {

enum class Marker { Disc, Square, Triangle, Diamond, Cross, Down, Plus, Ring };

/// How a series looks. Lightness, dashes and marker differ from style to style, so that figures are
/// readable in grey.
struct Style {
  draw::Colour colour;
  std::span<const double> dashes;  ///< on and off lengths, px; empty = solid
  Marker marker;
  double width_px;
};

inline constexpr int kStyles = 8;

/// Throws std::invalid_argument for another number than 0 .. kStyles - 1.
const Style& style_of(int number);

}  // namespace tagmint::plot
