#pragma once

#include <string>
#include <vector>

#include "draw/sheet_decor.h"
#include "draw/sheet_plan.h"
#include "tagmint/detect/geometry.h"

namespace tagmint::test {

/// A sheet with all that can stand on one.
struct SampleSheet {
  draw::SheetPlan plan;
  draw::SheetDecor decor;
};

/// Tags of a bundled family, with title, labels, cut marks, ruler and notes.
///   count   ids 0 .. count-1
SampleSheet sample_sheet(const std::string& family, double edge_mm, std::size_t count);

/// Where the plan has the corners of a tag's border square, in pixels of the page drawn at `dpi`,
/// in the order of detect::kTagCorners.
detect::Corners planned_corners(const draw::SheetPlan& plan, const draw::PlacedTag& tag,
                                double dpi);

}  // namespace tagmint::test
