#include "draw/sheet_writer.h"

#include "draw/sheet_bookmarks.h"
#include "draw/sheet_page.h"

namespace tagmint::draw {
namespace {

std::string sheet_text(const SheetPlan& plan, const SheetDecor& decor, std::size_t first,
                       std::size_t last, FileKind kind, const FileOptions& options) {
  std::string content;
  write_sheet(plan, decor, first, last, kind, options,
              [&](std::string_view bytes) { content += bytes; });
  return content;
}

}  // namespace

void write_sheet(const SheetPlan& plan, const SheetDecor& decor, std::size_t first,
                 std::size_t last, FileKind kind, const FileOptions& options, ByteSink sink,
                 const std::function<void(std::size_t page)>& on_page) {
  const std::unique_ptr<Canvas> canvas = make_canvas(kind, options, std::move(sink));
  for (std::size_t page = first; page < last; ++page) {
    canvas->begin_page({.width_mm = plan.options.page_width_mm,
                        .height_mm = plan.options.page_height_mm,
                        .label = "",
                        .bookmarks = page_bookmarks(plan, page)});
    if (has_white_ground(kind, options)) canvas->paint_ground(paper_of(plan, page));
    draw_page(*canvas, plan, page, decor);
    canvas->end_page();
    if (on_page) on_page(page);
  }
  canvas->finish();
}

std::string sheet_pdf(const SheetPlan& plan, const SheetDecor& decor,
                      const std::string& metadata_title) {
  FileOptions options;
  options.title = metadata_title;
  return sheet_text(plan, decor, 0, plan.pages.size(), FileKind::Pdf, options);
}

std::string sheet_svg(const SheetPlan& plan, std::size_t page, const SheetDecor& decor) {
  FileOptions options;
  options.title = decor.title;
  return sheet_text(plan, decor, page, page + 1, FileKind::Svg, options);
}

std::string sheet_png(const SheetPlan& plan, std::size_t page, const SheetDecor& decor,
                      double dpi) {
  FileOptions options;
  options.dpi = dpi;
  return sheet_text(plan, decor, page, page + 1, FileKind::Png, options);
}

}  // namespace tagmint::draw
