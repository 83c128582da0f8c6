#include "board/clearance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "draw/nested_tags.h"
#include "draw/units.h"

namespace tagmint::board {
namespace {

using detect::Corners;
using detect::Point;

// Places are told rounded to a micrometre, so this much is not too near.
constexpr double kSlackMm = 1e-3;

/// Cells between the rim of the tag and the square that holds all cells which may be black.
int white_rim_cells(const codec::Layout& layout) {
  const int width = layout.width();
  for (int rim = 0; rim < width / 2; ++rim) {
    // All four sides of a ring look alike: its top row tells.
    for (int x = rim; x < width - rim; ++x) {
      const codec::Cell cell = layout.cell(x, rim);
      if (cell == codec::Cell::Black || cell == codec::Cell::Data) return rim;
    }
  }
  return width / 2;
}

double cell_mm(const BoardTag& tag) { return tag.edge_mm / tag.layout.width_at_border(); }

/// Whether a line along a side of `a` has all of `b` beyond it.
bool side_separates(const Corners& a, const Corners& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point from = a[i];
    const Point along = a[(i + 1) % a.size()] - from;
    const double length = detect::length(along);
    // Counter-clockwise as seen with y down: the outside is on the clockwise side of each step.
    const bool beyond = std::all_of(b.begin(), b.end(), [&](Point p) {
      return detect::cross(along, p - from) / length > -kSlackMm;
    });
    if (beyond) return true;
  }
  return false;
}

bool overlap(const Corners& a, const Corners& b) {
  return !side_separates(a, b) && !side_separates(b, a);
}

bool holds(const Corners& outer, const Corners& inner) {
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const Point along = outer[(i + 1) % outer.size()] - outer[i];
    for (const Point p : inner) {
      if (detect::cross(along, p - outer[i]) / detect::length(along) > kSlackMm) return false;
    }
  }
  return true;
}

bool stands_in_hole(const BoardTag& inner, const BoardTag& outer) {
  const int hole = draw::hole_cells(outer.layout);
  return hole > 0 && holds(square_around(outer, hole * cell_mm(outer)),
                           square_around(inner, quiet_side_mm(inner)));
}

std::string name_of(const BoardTag& tag) {
  return fmt::format("{} {} at {}, {}", tag.family->name(), tag.id,
                     draw::format_mm(tag.centre_mm.x), draw::format_mm(tag.centre_mm.y));
}

/// Sets the host of `tag` to `host` unless it stands in a hole that is smaller.
void take_host(std::vector<BoardTag>& tags, std::size_t tag, std::size_t host) {
  std::optional<std::size_t>& known = tags[tag].host;
  if (!known || tags[host].edge_mm < tags[*known].edge_mm) known = host;
}

}  // namespace

double quiet_side_mm(const BoardTag& tag) {
  return draw::side_with_quiet_zone(tag.layout, tag.edge_mm);
}

double ink_side_mm(const BoardTag& tag) {
  return (tag.layout.width() - 2 * white_rim_cells(tag.layout)) * cell_mm(tag);
}

double least_gap_mm(const codec::Layout& layout, double edge_mm) {
  const double quiet = draw::side_with_quiet_zone(layout, edge_mm);
  const double cell = edge_mm / layout.width_at_border();
  const double ink = (layout.width() - 2 * white_rim_cells(layout)) * cell;
  return (quiet + ink) / 2 - edge_mm;
}

draw::Box extent_of(const std::vector<BoardTag>& tags) {
  Point low = tags.at(0).centre_mm;
  Point high = low;
  for (const BoardTag& tag : tags) {
    for (const Point p : square_around(tag, quiet_side_mm(tag))) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  return {low.x, low.y, high.x - low.x, high.y - low.y};
}

void check_each_once(const std::vector<BoardTag>& tags) {
  std::set<std::pair<std::string, codec::TagId>> seen;
  for (const BoardTag& tag : tags) {
    if (!seen.insert({tag.family->name(), tag.id}).second) {
      throw std::invalid_argument(
          fmt::format("tag {} of {} would stand on the board twice; give each place an id of its "
                      "own",
                      tag.id, tag.family->name()));
    }
  }
}

void check_clearance(std::vector<BoardTag>& tags) {
  check_each_once(tags);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    for (std::size_t j = i + 1; j < tags.size(); ++j) {
      if (stands_in_hole(tags[i], tags[j])) {
        take_host(tags, i, j);
      } else if (stands_in_hole(tags[j], tags[i])) {
        take_host(tags, j, i);
      } else if (overlap(square_around(tags[i], quiet_side_mm(tags[i])),
                         square_around(tags[j], ink_side_mm(tags[j]))) ||
                 overlap(square_around(tags[i], ink_side_mm(tags[i])),
                         square_around(tags[j], quiet_side_mm(tags[j])))) {
        throw draw::DoesNotFit(
            fmt::format("{} and {} stand too near: one reaches into the quiet zone of the other",
                        name_of(tags[i]), name_of(tags[j])),
            "", "move them apart or make one of them smaller");
      }
    }
  }
}

}  // namespace tagmint::board
