#pragma once

#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/layout.h"
#include "tagmint/detect/geometry.h"

namespace tagmint::scene {

/// What a tag is on paper, as rectangles on the tag plane (border square = [-1,1]^2, y down), each
/// a run of equal cells in one row. Corners clockwise as seen, first the top-left one.
using Rectangle = std::vector<detect::Point>;

struct TagShape {
  std::vector<Rectangle> paper;  ///< everything that is not background: the tag and its quiet zone
  std::vector<Rectangle> tag;    ///< the tag's own cells
  std::vector<Rectangle> black;  ///< the black cells
};

/// The shape of a tag with `quiet_zone_cells` (>= 0) of white paper around every cell that the
/// layout has; holes of the layout that are wider than that stay holes.
TagShape tag_shape(const codec::Layout& layout, codec::Codeword codeword, int quiet_zone_cells);

}  // namespace tagmint::scene
