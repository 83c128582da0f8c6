#pragma once

#include "pipeline/stage_types.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Stage 6: quads from the thresholded image -> quads whose sides follow the gradient of the
/// full-resolution image [WangOlson2016, section III-F].
struct RefineOptions {
  /// How far from the given side its true edge may lie, full-resolution px, > 0.
  double search_px = 2.0;
  /// Largest width in cells of the border squares looked for: the search ends before the next edge
  /// of the same sign, two cells away, and small cells are measured in their own way. 0 = not
  /// known, no such limit.
  int cells_at_border = 0;
};

/// Fits each side again: looks along the normal at places spread over the side for the steepest
/// change of the expected sign (dark inside, or bright inside for a reversed border), takes the
/// mean of the changes around it, fits a line to these places, and intersects the lines. A second
/// round starts from the first one's sides with a narrower search.
///   full     full-resolution image; places outside it take no part
///   quad     convex, counter-clockwise as seen, full-resolution px
///   returns  the refined quad. A side keeps its line when too few places have an edge; the whole
///            quad stays when the new one would not be convex or would leave the search range.
///   cost     about 30 gray values for each of at most kMaxEdgeSamples places a side and round
Quad refine_edges(ImageView full, const Quad& quad, const RefineOptions& options);

/// Places looked at along a side: one a pixel of its length, within these bounds. Beyond, the
/// corner's error is no longer that of noise but of lens and paper.
inline constexpr int kMinEdgeSamples = 8;
inline constexpr int kMaxEdgeSamples = 64;

}  // namespace tagmint::detect
