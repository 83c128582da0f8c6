#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "numerics/union_find.h"
#include "pipeline/stage_types.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Buffers that segment() keeps from one image to the next.
struct SegmentScratch {
  UnionFind sets;                             ///< over runs, weighted by their pixels
  std::vector<std::uint32_t> root_component;  ///< by root run
};

/// Stage 3: connected components of the black and of the white pixels [WangOlson2016, section
/// III-C]. White pixels are 8-connected and black ones 4-connected, as in the reference detector:
/// black tags that touch at a corner stay apart, and white lines a pixel wide hold together.
///   three_valued   kBlack, kWhite and kUnknown pixels
///   out            components 0, 1, 2, ... in the order of their first pixels, row-major; unknown
///                  pixels are in none
///   cost           O(pixels / 8 + runs alpha(runs)): sets are joined run by run, not pixel by
///   pixel
void segment(ImageView three_valued, SegmentScratch& scratch, Components& out);

/// Component of each pixel, row-major, kNoComponent for unknown ones: the picture of the components
/// for debugging and tests.
std::vector<std::uint32_t> component_of_each_pixel(const Components& components);

}  // namespace tagmint::detect
