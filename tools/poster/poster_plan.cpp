#include "poster/poster_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "draw/units.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::poster {
namespace {

using draw::Box;
using draw::format_mm;

// Sums of lengths are compared with this much room for rounding: a nanometre.
constexpr double kSlackMm = 1e-6;
constexpr double kMostPages = 10000;

void require(bool holds, const char* what, double value, const std::string& range) {
  if (!holds) {
    throw std::invalid_argument(fmt::format("{} of {} cannot be; it is {}", what, value, range));
  }
}

void check(const PosterTag& tag, const PosterOptions& options) {
  for (const double side : {options.paper_width_mm, options.paper_height_mm}) {
    require(side > 0 && side <= draw::kMaxPageMm, "a paper side in mm", side,
            fmt::format("above 0 up to {}", draw::kMaxPageMm));
  }
  require(std::isfinite(tag.edge_mm) && tag.edge_mm > 0, "an edge in mm", tag.edge_mm, "above 0");
  require(options.overlap_mm >= 0, "an overlap in mm", options.overlap_mm, "0 or more");
  require(options.margin_mm >= kLeastMarginMm, "a margin in mm", options.margin_mm,
          fmt::format("at least {}, for the marks and page numbers in it", kLeastMarginMm));
  if (tag.id >= tag.family->size()) {
    throw std::invalid_argument(fmt::format("id {} is not in {}; its ids are 0-{}", tag.id,
                                            tag.family->name(), tag.family->size() - 1));
  }
}

/// Rows of one orientation: what a page prints, and how many a row takes.
struct RowKind {
  double width_mm;
  double height_mm;
  double columns = 0;
};

RowKind row_kind(double paper_width, double paper_height, double side,
                 const PosterOptions& options) {
  RowKind kind{paper_width - 2 * options.margin_mm, paper_height - 2 * options.margin_mm};
  const double shorter = std::min(kind.width_mm, kind.height_mm);
  // Overlaps of more than half a page would let three pages share a place.
  if (shorter <= 0 || shorter < 2 * options.overlap_mm) {
    throw draw::DoesNotFit(
        fmt::format("margins of {} and an overlap of {} leave too little of the paper",
                    format_mm(options.margin_mm), format_mm(options.overlap_mm)),
        fmt::format("{} x {}", format_mm(paper_width), format_mm(paper_height)),
        "take a larger paper, a smaller margin or a smaller overlap");
  }
  kind.columns = std::max(1.0, std::ceil((side - options.overlap_mm - kSlackMm) /
                                         (kind.width_mm - options.overlap_mm)));
  return kind;
}

/// Rows of both orientations, as given above turned.
struct Tiling {
  double as_given = 0;  // rows
  double turned = 0;
  double pages = 0;
};

/// The tiling of fewest pages; of those, one whose rows lie all the same way.
Tiling fewest_pages(const RowKind& as_given, const RowKind& turned, double side,
                    const PosterOptions& options) {
  const double step_given = as_given.height_mm - options.overlap_mm;
  const double step_turned = turned.height_mm - options.overlap_mm;
  const double to_cover = std::max(side - options.overlap_mm - kSlackMm, 0.0);
  const auto rows_for = [](double length, double step) {
    return std::max(0.0, std::ceil(length / step));
  };
  const auto pages = [&](double given, double turn) {
    return Tiling{given, turn, given * as_given.columns + turn * turned.columns};
  };
  const Tiling all_given = pages(std::max(1.0, rows_for(to_cover, step_given)), 0);
  const Tiling all_turned = pages(0, std::max(1.0, rows_for(to_cover, step_turned)));
  if (options.orientation == Orientation::Turned) return all_turned;
  Tiling best = all_given;
  if (options.orientation == Orientation::AsGiven || best.pages > kMostPages) return best;
  for (double turn = 1; turn < all_turned.turned; ++turn) {
    const Tiling mixed = pages(rows_for(to_cover - turn * step_turned, step_given), turn);
    if (mixed.pages < best.pages) best = mixed;
  }
  return best;
}

bool overlaps(const Box& a, const Box& b) {
  return a.x_mm < b.right_mm() - kSlackMm && b.x_mm < a.right_mm() - kSlackMm &&
         a.y_mm < b.bottom_mm() - kSlackMm && b.y_mm < a.bottom_mm() - kSlackMm;
}

/// Whether a black cell of the tag reaches into `part`.
bool has_black(const PosterTag& tag, const Box& outer, const Box& part) {
  const codec::TagCells cells =
      codec::tag_cells(tag.family->layout(), tag.family->codeword(tag.id));
  const double cell = outer.width_mm / cells.width();
  for (int y = 0; y < cells.width(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      const Box place = {outer.x_mm + x * cell, outer.y_mm + y * cell, cell, cell};
      if (cells.at(x, y) == codec::Cell::Black && overlaps(place, part)) return true;
    }
  }
  return false;
}

/// Adds the pages of a row whose upper side is at `top`.
void add_row(PosterPlan& plan, const RowKind& kind, double top) {
  const int row = plan.rows();
  const int columns = static_cast<int>(kind.columns);
  const double step = kind.width_mm - plan.overlap_mm;
  // What the pages show beyond the poster is shared by its two sides.
  const double left = (plan.side_mm - (columns - 1) * step - kind.width_mm) / 2;
  plan.columns.push_back(columns);
  for (int column = 0; column < columns; ++column) {
    const Box part = {left + column * step, top, kind.width_mm, kind.height_mm};
    const bool black = std::any_of(plan.tags.begin(), plan.tags.end(), [&](const PosterTag& tag) {
      return has_black(tag, plan.outer(tag), part);
    });
    plan.pages.push_back({row, column, part, !black});
  }
}

Box centred(double side, double poster_side) {
  return {(poster_side - side) / 2, (poster_side - side) / 2, side, side};
}

}  // namespace

Box PosterPlan::border_square(const PosterTag& tag) const { return centred(tag.edge_mm, side_mm); }

Box PosterPlan::outer(const PosterTag& tag) const {
  return centred(draw::outer_of_edge(tag.family->layout(), tag.edge_mm), side_mm);
}

PosterPlan plan_poster(const PosterTag& tag, std::span<const draw::NestedRequest> nested,
                       const PosterOptions& options) {
  check(tag, options);
  PosterPlan plan;
  plan.tags.push_back(tag);
  const std::vector<double> edges = draw::nested_edges(*tag.family, tag.edge_mm, nested);
  for (std::size_t i = 0; i < nested.size(); ++i) {
    plan.tags.push_back({nested[i].family, nested[i].id, edges[i]});
  }
  plan.side_mm = draw::side_with_quiet_zone(tag.family->layout(), tag.edge_mm);
  const double width = options.paper_width_mm;
  const double height = options.paper_height_mm;
  const RowKind as_given = row_kind(width, height, plan.side_mm, options);
  const RowKind turned = row_kind(height, width, plan.side_mm, options);
  const Tiling tiling = fewest_pages(as_given, turned, plan.side_mm, options);
  if (tiling.pages > kMostPages) {
    throw draw::DoesNotFit(
        fmt::format("a poster of {} takes {:.0f} pages of {} x {}; the limit is {:.0f}",
                    format_mm(plan.side_mm), tiling.pages, format_mm(width), format_mm(height),
                    kMostPages),
        "--edge", "take a larger paper or a smaller edge");
  }
  plan.margin_mm = options.margin_mm;
  plan.overlap_mm = options.overlap_mm;
  const double height_in_all = tiling.as_given * (as_given.height_mm - plan.overlap_mm) +
                               tiling.turned * (turned.height_mm - plan.overlap_mm) +
                               plan.overlap_mm;
  double top = (plan.side_mm - height_in_all) / 2;
  for (int row = 0; row < tiling.as_given + tiling.turned; ++row) {
    const RowKind& kind = row < tiling.as_given ? as_given : turned;
    add_row(plan, kind, top);
    top += kind.height_mm - plan.overlap_mm;
  }
  return plan;
}

}  // namespace tagmint::poster
