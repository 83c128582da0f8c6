#pragma once

#include <string>
#include <vector>

#include "draw/file_canvas.h"
#include "draw/sheet_decor.h"
#include "draw/sheet_plan.h"
#include "tagmint/detect/image.h"

namespace tagmint::test {

/// A way from a plan to what other programs make of our file.
struct Printed {
  const char* name;  ///< "SVG, Chromium, Poppler"
  bool whole_dots;   ///< a picture of ours, for which the program makes cells whole dots
  /// The first page at that many pixels per inch.
  detect::Image (*picture)(const draw::SheetPlan& plan, const draw::SheetDecor& decor, double dpi);
};

/// Those for which the programs are installed.
std::vector<Printed> printed_kinds();

/// One page as the content of a file.
std::string file_content(const draw::SheetPlan& plan, const draw::SheetDecor& decor,
                         draw::FileKind kind, const draw::FileOptions& options = {});

}  // namespace tagmint::test
