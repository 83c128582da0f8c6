#include "poster/poster_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "draw/tag_outline.h"
#include "draw/text.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::poster {
namespace {

using draw::Box;
using draw::Path;
using draw::PathPoint;

constexpr double kMarkGray = 0.4;
constexpr double kDashGray = 0.7;
constexpr double kNoteGray = 0.5;
constexpr double kLineMm = 0.1;
constexpr double kDashMm = 2.0;
// A dashed line runs this far outside the edge that is cut, so that it goes with the waste.
constexpr double kDashOutsideMm = 0.25;
// Ends of a tick, from the printed part outwards.
constexpr double kTickFromMm = 0.5;
constexpr double kTickToMm = 5.5;
constexpr double kNoteSizeMm = 2.6;
constexpr double kNoteBaselineMm = 4.0;  // below the printed part
constexpr double kSlackMm = 1e-6;

PathPoint on_page(const PosterPlan& plan, const PosterPage& page, const PathPoint& p) {
  return {p.x - page.part.x_mm + plan.margin_mm, p.y - page.part.y_mm + plan.margin_mm};
}

const PosterPage& first_of_row(const PosterPlan& plan, int row) {
  return *std::find_if(plan.pages.begin(), plan.pages.end(),
                       [row](const PosterPage& page) { return page.row == row; });
}

bool is_last_in_row(const PosterPlan& plan, const PosterPage& page) {
  return page.column + 1 == plan.columns[static_cast<std::size_t>(page.row)];
}

/// A straight edge to cut along: dashes just outside of it, and ticks at its ends.
struct CutEdge {
  PathPoint from;  // poster coordinates
  PathPoint to;
  PathPoint outwards;  // unit vector towards the waste
};

/// The edges that a page is cut along: where it is laid over a neighbour, and the poster's rim.
std::vector<CutEdge> cut_edges(const PosterPlan& plan, const PosterPage& page) {
  const Box& part = page.part;
  const bool last_row = page.row + 1 == plan.rows();
  const double left = page.column > 0 ? part.x_mm : 0;
  const double top = page.row > 0 ? part.y_mm : 0;
  const double right = is_last_in_row(plan, page) ? plan.side_mm : part.right_mm();
  const double bottom = last_row ? plan.side_mm : part.bottom_mm();
  std::vector<CutEdge> edges = {{{left, top}, {left, bottom}, {-1, 0}},
                                {{left, top}, {right, top}, {0, -1}}};
  if (is_last_in_row(plan, page)) edges.push_back({{right, top}, {right, bottom}, {1, 0}});
  if (last_row) edges.push_back({{left, bottom}, {right, bottom}, {0, 1}});
  return edges;
}

void draw_cut_edges(draw::Canvas& canvas, const PosterPlan& plan, const PosterPage& page) {
  Path dashes;
  Path ticks;
  const double low_x = plan.margin_mm;
  const double low_y = plan.margin_mm;
  const double high_x = low_x + page.part.width_mm;
  const double high_y = low_y + page.part.height_mm;
  for (const CutEdge& edge : cut_edges(plan, page)) {
    const PathPoint from = on_page(plan, page, edge.from);
    const PathPoint to = on_page(plan, page, edge.to);
    const bool upright = edge.outwards.x != 0;
    const double start = upright ? from.y : from.x;
    const double end = upright ? to.y : to.x;
    const PathPoint shift = {kDashOutsideMm * edge.outwards.x, kDashOutsideMm * edge.outwards.y};
    for (double at = start; at < end; at += 2 * kDashMm) {
      const double stop = std::min(at + kDashMm, end);
      if (upright) {
        dashes.add_line(from.x + shift.x, at, from.x + shift.x, stop);
      } else {
        dashes.add_line(at, from.y + shift.y, stop, from.y + shift.y);
      }
    }
    if (upright) {
      ticks.add_line(from.x, low_y - kTickToMm, from.x, low_y - kTickFromMm);
      ticks.add_line(from.x, high_y + kTickFromMm, from.x, high_y + kTickToMm);
    } else {
      ticks.add_line(low_x - kTickToMm, from.y, low_x - kTickFromMm, from.y);
      ticks.add_line(high_x + kTickFromMm, from.y, high_x + kTickToMm, from.y);
    }
  }
  const auto pen = [](double gray) {
    return draw::Pen{.width_mm = kLineMm, .ink = {.gray = gray, .role = draw::Role::Cut}};
  };
  canvas.stroke(dashes, {}, pen(kDashGray));
  canvas.stroke(ticks, {}, pen(kMarkGray));
}

void draw_crosses(draw::Canvas& canvas, const PosterPlan& plan, const PosterPage& page) {
  Path path;
  for (const PathPoint& cross : crosses(plan, page)) {
    const PathPoint p = on_page(plan, page, cross);
    path.add_line(p.x - kCrossArmMm, p.y, p.x + kCrossArmMm, p.y);
    path.add_line(p.x, p.y - kCrossArmMm, p.x, p.y + kCrossArmMm);
    path.add_circle(p.x, p.y, 0.6 * kCrossArmMm);
  }
  if (path.empty()) return;
  canvas.stroke(path, {},
                {.width_mm = kLineMm, .ink = {.gray = kMarkGray, .role = draw::Role::Cut}});
}

/// Between the crosses of the lower margin.
void draw_note(draw::Canvas& canvas, const PosterPlan& plan, std::size_t index) {
  const PosterPage& page = plan.pages[index];
  const PosterTag& tag = plan.tags[0];
  const std::string text =
      fmt::format("{} {}  |  row {} of {}, column {} of {}  |  page {} of {}{}  |  print at 100 %",
                  tag.family->name(), tag.id, page.row + 1, plan.rows(), page.column + 1,
                  plan.columns[static_cast<std::size_t>(page.row)], index + 2,
                  plan.pages.size() + 1, page.all_white ? "  |  all white" : "");
  const double taken = plan.overlap_mm + 2 * kCrossArmMm + 2;  // on each side
  draw::draw_text(canvas, text, plan.page_width_mm(page) / 2,
                  plan.margin_mm + page.part.height_mm + kNoteBaselineMm,
                  std::max(page.part.width_mm - 2 * taken, 5.0),
                  {.size_mm = kNoteSizeMm,
                   .ink = {.gray = kNoteGray, .role = draw::Role::Note},
                   .align = draw::TextAlign::Centre});
}

}  // namespace

std::vector<PathPoint> crosses(const PosterPlan& plan, const PosterPage& page) {
  std::vector<PathPoint> places;
  const Box& part = page.part;
  const double above = part.y_mm - kCrossDistanceMm;
  const double below = part.bottom_mm() + kCrossDistanceMm;
  const auto upright_joint = [&](double x) {
    places.push_back({x, above});
    places.push_back({x, below});
  };
  if (page.column > 0) upright_joint(part.x_mm);
  if (!is_last_in_row(plan, page)) upright_joint(part.right_mm() - plan.overlap_mm);

  const auto lying_joint = [&](double y) {
    if (page.column == 0) places.push_back({-kCrossDistanceMm, y});
    if (is_last_in_row(plan, page)) places.push_back({plan.side_mm + kCrossDistanceMm, y});
  };
  if (page.row > 0) lying_joint(part.y_mm);
  if (page.row + 1 < plan.rows()) lying_joint(first_of_row(plan, page.row + 1).part.y_mm);
  return places;
}

Path black_on_page(const PosterPlan& plan, const PosterPage& page, const PosterTag& tag) {
  const codec::TagCells cells =
      codec::tag_cells(tag.family->layout(), tag.family->codeword(tag.id));
  const int width = cells.width();
  const Box outer = plan.outer(tag);
  const double cell = outer.width_mm / width;
  const Box& part = page.part;
  // Cells beyond the part are left out, those that it cuts keep what is in it: grid lines outside
  // of it become its edges.
  std::vector<codec::Cell> seen;
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) {
      const double left = outer.x_mm + x * cell;
      const double top = outer.y_mm + y * cell;
      const bool inside = left < part.right_mm() - kSlackMm && left + cell > part.x_mm + kSlackMm &&
                          top < part.bottom_mm() - kSlackMm && top + cell > part.y_mm + kSlackMm;
      seen.push_back(inside ? cells.at(x, y) : codec::Cell::None);
    }
  }
  Path path;
  for (const draw::Outline& outline : draw::black_outlines(codec::TagCells(width, seen))) {
    std::vector<PathPoint> corners;
    for (const codec::CellPosition& corner : outline) {
      corners.push_back(
          on_page(plan, page,
                  {std::clamp(outer.x_mm + corner.x * cell, part.x_mm, part.right_mm()),
                   std::clamp(outer.y_mm + corner.y * cell, part.y_mm, part.bottom_mm())}));
    }
    path.add_polygon(corners);
  }
  return path;
}

void draw_poster_page(draw::Canvas& canvas, const PosterPlan& plan, std::size_t index) {
  const PosterPage& page = plan.pages[index];
  for (const PosterTag& tag : plan.tags) {
    const Path black = black_on_page(plan, page, tag);
    if (!black.empty()) {
      canvas.fill(black, {}, {.gray = 0.0, .role = draw::Role::Tag});
    }
  }
  draw_cut_edges(canvas, plan, page);
  draw_crosses(canvas, plan, page);
  draw_note(canvas, plan, index);
}

}  // namespace tagmint::poster
