#include "draw/sheet_bookmarks.h"

#include <fmt/format.h>

#include "draw/units.h"

namespace tagmint::draw {
namespace {

/// A group's tags on a page; they stand one after another.
struct Share {
  std::size_t group;
  std::vector<codec::TagId> ids;
};

std::vector<Share> shares_of(const SheetPage& page) {
  std::vector<Share> shares;
  for (const PlacedTag& tag : page.tags) {
    if (shares.empty() || shares.back().group != tag.group) shares.push_back({tag.group, {}});
    shares.back().ids.push_back(tag.id);
  }
  return shares;
}

}  // namespace

std::string id_text(std::span<const codec::TagId> ids) {
  constexpr int kMostRanges = 5;
  std::string text;
  int ranges = 0;
  for (std::size_t first = 0; first < ids.size(); ++ranges) {
    std::size_t last = first;
    while (last + 1 < ids.size() && ids[last + 1] == ids[last] + 1) ++last;
    if (!text.empty()) text += ", ";
    text +=
        last == first ? fmt::format("{}", ids[first]) : fmt::format("{}-{}", ids[first], ids[last]);
    first = last + 1;
  }
  if (ranges <= kMostRanges) return text;
  return fmt::format("{} to {} ({} ids)", ids.front(), ids.back(), ids.size());
}

std::vector<std::string> page_contents(const SheetPlan& plan, std::size_t page) {
  std::vector<std::string> contents;
  for (const Share& share : shares_of(plan.pages[page])) {
    contents.push_back(
        fmt::format("{} {}", plan.groups[share.group].family->name(), id_text(share.ids)));
  }
  return contents;
}

std::vector<Bookmark> page_bookmarks(const SheetPlan& plan, std::size_t page) {
  std::vector<Bookmark> bookmarks;
  for (const Share& share : shares_of(plan.pages[page])) {
    const TagGroup& group = plan.groups[share.group];
    if (share.ids.front() == group.ids.front()) {
      const double outer = outer_of_edge(group.family->layout(), group.edge_mm);
      bookmarks.push_back({fmt::format("{}: edge {}, outer {}", group.family->name(),
                                       format_mm(group.edge_mm), format_mm(outer)),
                           0});
    }
    bookmarks.push_back({id_text(share.ids), 1});
  }
  return bookmarks;
}

}  // namespace tagmint::draw
