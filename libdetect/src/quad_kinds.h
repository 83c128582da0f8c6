#pragma once

#include <span>
#include <vector>

#include "pipeline/stage_types.h"
#include "tagmint/codec/layout.h"
#include "tagmint/detect/geometry.h"

namespace tagmint::detect {

/// Which border squares the families of a detector ask for.
struct QuadKinds {
  bool normal_borders = false;    ///< black inside white
  bool reversed_borders = false;  ///< white inside black
  int cells_at_border = 0;        ///< the largest width of a border square, cells

  void add(const codec::Layout& layout) {
    (layout.reversed_border() ? reversed_borders : normal_borders) = true;
    if (layout.width_at_border() > cells_at_border) cells_at_border = layout.width_at_border();
  }
};

/// For debug pictures.
inline std::vector<Corners> corners_of(std::span<const Quad> quads) {
  std::vector<Corners> corners;
  for (const Quad& quad : quads) corners.push_back(quad.corners);
  return corners;
}

}  // namespace tagmint::detect
