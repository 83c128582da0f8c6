#pragma once

#include <string>
#include <vector>

#include "draw/sheet_decor.h"
#include "draw/sheet_plan.h"

namespace tagmint::test {

/// A sheet with all that can stand on one.
struct SampleSheet {
  draw::SheetPlan plan;
  draw::SheetDecor decor;
};

/// Tags of a bundled family, with title, labels, cut marks, ruler and notes.
///   count   ids 0 .. count-1
SampleSheet sample_sheet(const std::string& family, double edge_mm, std::size_t count);

}  // namespace tagmint::test
