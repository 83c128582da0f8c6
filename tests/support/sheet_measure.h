#pragma once

#include <cstddef>

#include "draw/sheet_plan.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::test {

/// What a raster picture of a page shows at the places of its plan.
struct SheetMeasures {
  int tags = 0;
  int edges = 0;                ///< places where a tag turns from black to white or back
  double largest_error_mm = 0;  ///< between such an edge and its place in the plan
  int wrong_cells = 0;          ///< cells whose middle is not black or white as it should be
  int gray_in_black = 0;        ///< pixels well within black areas that are not black
  int ink_in_quiet = 0;         ///< pixels well within quiet zones that are not white
  int labels = 0;               ///< tags with ink in their label band
  int ink_at_labels_rim = 0;    ///< pixels next to the quiet zone, above the label, that have ink
};

/// Compares a picture of a page with its plan.
///   dpi   pixels per inch of the picture, whose top-left corner is the page's
SheetMeasures measure_page(const detect::ImageView& picture, double dpi,
                           const draw::SheetPlan& plan, std::size_t page);

}  // namespace tagmint::test
