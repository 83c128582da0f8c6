#include "draw/sheet_writer.h"

#include <string_view>

#include "draw/cairo_surface.h"
#include "draw/sheet_page.h"

namespace tagmint::draw {
namespace {

/// Cairo numbers all surfaces of a process and writes the number as the id of the outermost group,
/// which nothing refers to; without it, the same page is the same file.
std::string without_surface_number(std::string svg) {
  const std::string_view start = "<g id=\"surface";
  const std::size_t at = svg.find(start);
  const std::size_t end = at == std::string::npos ? at : svg.find('"', at + start.size());
  if (end != std::string::npos) svg.replace(at, end + 1 - at, "<g id=\"page\"");
  return svg;
}

}  // namespace

std::string sheet_pdf(const SheetPlan& plan, const SheetDecor& decor,
                      const std::string& metadata_title) {
  CairoCanvas canvas =
      CairoCanvas::pdf(plan.options.page_width_mm, plan.options.page_height_mm, metadata_title);
  for (std::size_t page = 0; page < plan.pages.size(); ++page) {
    draw_page(canvas.context(), plan, page, decor);
    canvas.finish_page();
  }
  return canvas.finish();
}

std::string sheet_svg(const SheetPlan& plan, std::size_t page, const SheetDecor& decor) {
  CairoCanvas canvas = CairoCanvas::svg(plan.options.page_width_mm, plan.options.page_height_mm);
  draw_paper(canvas.context(), plan, page);
  draw_page(canvas.context(), plan, page, decor);
  return without_surface_number(canvas.finish());
}

std::string sheet_png(const SheetPlan& plan, std::size_t page, const SheetDecor& decor,
                      double dpi) {
  CairoCanvas canvas =
      CairoCanvas::png(plan.options.page_width_mm, plan.options.page_height_mm, dpi);
  draw_page(canvas.context(), plan, page, decor);
  return canvas.finish();
}

}  // namespace tagmint::draw
