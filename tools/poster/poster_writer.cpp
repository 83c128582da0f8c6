#include "poster/poster_writer.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "poster/poster_map.h"
#include "poster/poster_page.h"

namespace tagmint::poster {
namespace {

/// What viewers call a page, and the entry of the first of each row in the outline.
draw::PageSetup setup_of(const PosterPlan& plan, const PosterPage& page) {
  draw::PageSetup setup{.width_mm = plan.page_width_mm(page),
                        .height_mm = plan.page_height_mm(page),
                        .label = fmt::format("row {} column {}", page.row + 1, page.column + 1),
                        .bookmarks = {}};
  if (page.column == 0) setup.bookmarks.push_back({fmt::format("Row {}", page.row + 1), 0});
  return setup;
}

}  // namespace

void write_poster(const PosterPlan& plan, draw::FileKind kind, const draw::FileOptions& options,
                  draw::ByteSink sink, const std::function<void(std::size_t done)>& on_page) {
  const std::unique_ptr<draw::Canvas> canvas = draw::make_canvas(kind, options, std::move(sink));
  draw::PageSetup map = setup_of(plan, plan.pages[0]);
  map.label = "map";
  map.bookmarks = {{"Map of the pages", 0}};
  canvas->begin_page(map);
  draw_poster_map(*canvas, plan);
  canvas->end_page();
  for (std::size_t i = 0; i < plan.pages.size(); ++i) {
    canvas->begin_page(setup_of(plan, plan.pages[i]));
    draw_poster_page(*canvas, plan, i);
    canvas->end_page();
    if (on_page) on_page(i + 2);
  }
  canvas->finish();
}

}  // namespace tagmint::poster
