#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "numerics/union_find.h"
#include "pipeline/stage_types.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// A horizontal stretch of pixels of one value, [begin, end) in its row.
struct PixelRun {
  std::int32_t begin = 0;
  std::int32_t end = 0;
  std::uint8_t value = 0;
};

/// Buffers that segment() keeps from one image to the next.
struct SegmentScratch {
  std::vector<PixelRun> runs;             ///< black and white runs, row by row
  std::vector<std::size_t> row_begin;     ///< runs of row y are row_begin[y] .. row_begin[y + 1]
  UnionFind sets;                         ///< over runs
  std::vector<std::uint32_t> root_label;  ///< by root run
};

/// Stage 3: connected components of the black and of the white pixels [WangOlson2016, section
/// III-C]. White pixels are 8-connected and black ones 4-connected, as in the reference detector:
/// black tags that touch at a corner stay apart, and white lines a pixel wide hold together.
///   three_valued   kBlack, kWhite and kUnknown pixels
///   out            labels 0, 1, 2, ... in the order of each component's first pixel, row-major;
///                  kNoComponent for unknown pixels
///   cost           O(pixels + runs alpha(runs)): sets are joined run by run, not pixel by pixel
void segment(ImageView three_valued, SegmentScratch& scratch, Labels& out);

}  // namespace tagmint::detect
