#include "io/family_kinds/layout_of_tags.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "tagmint/codec/layout_presets.h"

namespace tagmint::io {
namespace {

using codec::Cell;
using codec::Layout;
using codec::TagCells;

bool fits(const Layout& layout, const TagCells& tag) {
  if (tag.width() != layout.width()) return false;
  for (int y = 0; y < layout.width(); ++y) {
    for (int x = 0; x < layout.width(); ++x) {
      const Cell wanted = layout.cell(x, y);
      const Cell found = tag.at(x, y);
      if (wanted == Cell::Data ? found == Cell::None : found != wanted) return false;
    }
  }
  return true;
}

int fixed_cells(const Layout& layout) { return layout.width() * layout.width() - layout.bits(); }

/// Data where some tag differs from the first one.
std::string changing_cells(const std::vector<TagCells>& tags) {
  const int width = tags.front().width();
  std::string cells;
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) {
      char cell = char(tags.front().at(x, y));
      for (const TagCells& tag : tags) {
        if (char(tag.at(x, y)) != cell) cell = char(Cell::Data);
      }
      cells += cell;
    }
  }
  return cells;
}

/// Data spreads to the cells that quarter turns make of data cells.
void close_under_turns(std::string& cells, int width) {
  for (int turn = 0; turn < 3; ++turn) {
    const std::string before = cells;
    for (int y = 0; y < width; ++y) {
      for (int x = 0; x < width; ++x) {
        if (before[static_cast<std::size_t>(y * width + x)] == char(Cell::Data)) {
          cells[static_cast<std::size_t>(x * width + width - 1 - y)] = char(Cell::Data);
        }
      }
    }
  }
}

}  // namespace

std::size_t first_misfit(const Layout& layout, const std::vector<TagCells>& tags) {
  std::size_t i = 0;
  while (i < tags.size() && fits(layout, tags[i])) ++i;
  return i;
}

std::vector<Layout> possible_layouts(const std::vector<TagCells>& tags) {
  const int width = tags.front().width();
  std::vector<Layout> layouts;
  for (Layout (*preset)(int) :
       {codec::classic_layout, codec::standard_layout, codec::circle_layout}) {
    try {
      Layout layout = preset(width);
      if (first_misfit(layout, tags) == tags.size()) layouts.push_back(std::move(layout));
    } catch (const std::invalid_argument&) {  // no such layout of this width
    }
  }
  std::stable_sort(layouts.begin(), layouts.end(), [](const Layout& a, const Layout& b) {
    return fixed_cells(a) > fixed_cells(b);
  });
  std::string cells = changing_cells(tags);
  close_under_turns(cells, width);
  try {
    layouts.emplace_back(cells);
  } catch (const std::invalid_argument&) {
    if (layouts.empty()) throw;
  }
  return layouts;
}

}  // namespace tagmint::io
