#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "draw/file_canvas.h"
#include "draw/sheet_decor.h"
#include "draw/sheet_plan.h"

namespace tagmint::draw {

/// Draws pages of a plan as one file and completes it. Throws codec::OutputError where it cannot be
/// drawn, std::invalid_argument for a text that is not UTF-8, std::logic_error for several pages in
/// a kind of file that holds one, and what the sink throws.
///   first, last   pages [first, last) of the plan
///   on_page       called after each page
void write_sheet(const SheetPlan& plan, const SheetDecor& decor, std::size_t first,
                 std::size_t last, FileKind kind, const FileOptions& options, ByteSink sink,
                 const std::function<void(std::size_t page)>& on_page = {});

/// All pages of a plan as the content of a PDF file.
///   metadata_title   noted in the file
std::string sheet_pdf(const SheetPlan& plan, const SheetDecor& decor,
                      const std::string& metadata_title);

/// One page as the content of an SVG file.
std::string sheet_svg(const SheetPlan& plan, std::size_t page, const SheetDecor& decor);

/// One page as the content of a gray PNG file.
///   dpi   pixels per inch, > 0; noted in the file
std::string sheet_png(const SheetPlan& plan, std::size_t page, const SheetDecor& decor, double dpi);

}  // namespace tagmint::draw
