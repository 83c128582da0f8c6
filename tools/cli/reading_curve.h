#pragma once

#include "tagmint/codec/layout.h"

namespace tagmint::cli {

/// How well the detector reads cells of one size, frontal tags in a picture with blur 0.5 px and
/// noise 5 (docs/choose.md, "What can be read").
struct CellReading {
  double border_found = 0;  ///< share of tags whose border is found and believed
  double wrong_cells = 0;   ///< share of cells read wrongly in those, below 1/2
};

/// The measured figures for that layout, linear between the sizes measured; border_found never
/// falls and wrong_cells never grows with the size.
///   cell_px   side of a cell, px, at least 0
CellReading cell_reading(const codec::Layout& layout, double cell_px);

/// Expected share of tags that are found and have at most `max_errors` wrong cells, were cells
/// wrong independently of each other. Never falls with cell_px or max_errors.
double share_found(const codec::Layout& layout, double cell_px, int max_errors);

/// The smallest cell, px, at which share_found() reaches `share`, to a thousandth.
///   share   0 to 1
double cell_px_for_share(const codec::Layout& layout, int max_errors, double share);

}  // namespace tagmint::cli
