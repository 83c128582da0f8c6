#pragma once

#include <cstddef>
#include <string>

#include "draw/sheet_decor.h"
#include "draw/sheet_plan.h"

namespace tagmint::draw {

/// Kinds of files that sheets are written as.
enum class SheetFormat { Pdf, Svg, Png };

/// All pages of a plan as the content of a PDF file. Lengths are exact to 1/256 pt (1.4 um).
///   metadata_title   noted in the file
/// Throws codec::OutputError when Cairo fails, std::invalid_argument for a text that is not UTF-8.
std::string sheet_pdf(const SheetPlan& plan, const SheetDecor& decor,
                      const std::string& metadata_title);

/// One page as the content of an SVG file, its size in mm; exact to 1/256 mm (4 um). Errors as
/// sheet_pdf().
std::string sheet_svg(const SheetPlan& plan, std::size_t page, const SheetDecor& decor);

/// One page as the content of a gray PNG file; edges between pixels get the gray of their share.
/// Errors as sheet_pdf(), also for a picture that is too large.
///   dpi   pixels per inch, > 0; noted in the file
std::string sheet_png(const SheetPlan& plan, std::size_t page, const SheetDecor& decor, double dpi);

}  // namespace tagmint::draw
