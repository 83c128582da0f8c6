#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "draw/sheet_plan.h"

namespace tagmint::draw {

/// Ascending ids as people write them: "0-11", "3, 7, 9-12"; of many ranges the ends alone,
/// "3 to 95 (40 ids)".
std::string id_text(std::span<const codec::TagId> ids);

/// What each group of a page shows there, in the order of the page: "tag36h11 0-11".
std::vector<std::string> page_contents(const SheetPlan& plan, std::size_t page);

/// Bookmarks that lead to a page: one for each group that starts there, with its sizes, and below
/// it one for its ids on each page.
std::vector<Bookmark> page_bookmarks(const SheetPlan& plan, std::size_t page);

}  // namespace tagmint::draw
