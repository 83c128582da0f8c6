#include "poster/poster_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "draw/draw_tag.h"
#include "draw/ruler.h"
#include "draw/text.h"
#include "draw/units.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::poster {
namespace {

using draw::Box;
using draw::format_mm;
using draw::Path;

constexpr double kTextGray = 0.25;
constexpr double kTagGray = 0.8;  // of the tag below the map's lines and numbers
constexpr double kLineGray = 0.35;
constexpr double kTitleMm = 5.0;
constexpr double kTextMm = 2.8;
constexpr double kLineMm = 4.2;         // from baseline to baseline
constexpr double kSpaceMm = 4.0;        // between title, map and text
constexpr double kUsualSideMm = 140.0;  // of the paper; smaller ones get smaller letters
constexpr double kRowTextShare = 0.25;  // of the width, for what stands left of the map

constexpr std::array<std::string_view, 8> kHowTo = {
    "How to put the pages together:",
    "1. Print all pages at 100 %, not fitted to the page. Measure the ruler.",
    "2. Row by row: cut the left side of each page but the first along its dashed line,",
    "   between the two ticks. Lay it over the page before, so that the crosses above and",
    "   below the joint are whole again, and glue it.",
    "3. Cut the upper side of each row but the first in the same way, lay it over the row",
    "   above, so that the crosses left and right are whole again, and glue it.",
    "4. Cut the rim of the poster along the dashed line. The white rim belongs to the tag."};

/// What stands where on the page.
struct MapLayout {
  Box area;            // the page without its margin
  double scale = 1.0;  // of letters and lines
  double line_mm = kLineMm;
  Box map;  // the poster, and the row texts left of it
};

MapLayout lay_out(const PosterPlan& plan, std::size_t facts) {
  const PosterPage& first = plan.pages[0];
  MapLayout layout;
  layout.area = {plan.margin_mm, plan.margin_mm, first.part.width_mm, first.part.height_mm};
  layout.scale =
      std::min(1.0, std::min(layout.area.width_mm, layout.area.height_mm) / kUsualSideMm);
  layout.line_mm = layout.scale * kLineMm;
  const double above =
      layout.scale * (kTitleMm + kSpaceMm) + layout.line_mm * static_cast<double>(facts);
  const double below = layout.line_mm * kHowTo.size() + layout.scale * kSpaceMm +
                       layout.scale * kSpaceMm + draw::kRulerDepthMm;
  layout.map = {layout.area.x_mm, layout.area.y_mm + above, layout.area.width_mm,
                std::max(layout.area.height_mm - above - below, 1.0)};
  return layout;
}

draw::TextStyle text_style(double size_mm, draw::TextAlign align = draw::TextAlign::Left) {
  return {.size_mm = size_mm, .ink = {.gray = kTextGray, .role = draw::Role::Note}, .align = align};
}

/// From poster coordinates to the map: the pages' parts fill the room that the row texts leave.
struct MapScale {
  double x_mm = 0;
  double y_mm = 0;
  double share = 1;

  Box on_page(const Box& box) const {
    return {x_mm + share * box.x_mm, y_mm + share * box.y_mm, share * box.width_mm,
            share * box.height_mm};
  }
};

MapScale map_scale(const PosterPlan& plan, const MapLayout& layout) {
  double left = 0;
  double top = 0;
  double right = plan.side_mm;
  double bottom = plan.side_mm;
  for (const PosterPage& page : plan.pages) {
    left = std::min(left, page.part.x_mm);
    top = std::min(top, page.part.y_mm);
    right = std::max(right, page.part.right_mm());
    bottom = std::max(bottom, page.part.bottom_mm());
  }
  const double texts = kRowTextShare * layout.map.width_mm;
  MapScale scale;
  scale.share = std::min((layout.map.width_mm - texts) / (right - left),
                         layout.map.height_mm / (bottom - top));
  scale.x_mm = layout.map.x_mm + texts - scale.share * left;
  scale.y_mm = layout.map.y_mm - scale.share * top;
  return scale;
}

/// The page's number in what is seen of it, not in what its neighbours cover.
void draw_number(draw::Canvas& canvas, const PosterPlan& plan, std::size_t index, const Box& box) {
  const PosterPage& page = plan.pages[index];
  const double size = std::min({0.25 * box.width_mm, 0.25 * box.height_mm, 6.0});
  draw::draw_text(canvas, fmt::format("{}", index + 2), box.x_mm + box.width_mm / 2,
                  box.y_mm + 0.5 * box.height_mm, 0.9 * box.width_mm,
                  text_style(size, draw::TextAlign::Centre));
  if (!page.all_white) return;
  draw::draw_text(canvas, "white", box.x_mm + box.width_mm / 2,
                  box.y_mm + 0.5 * box.height_mm + size, 0.9 * box.width_mm,
                  text_style(0.6 * size, draw::TextAlign::Centre));
}

void draw_rows(draw::Canvas& canvas, const PosterPlan& plan, const MapLayout& layout,
               const MapScale& scale) {
  std::size_t first = 0;
  for (int row = 0; row < plan.rows(); ++row) {
    const auto columns = static_cast<std::size_t>(plan.columns[static_cast<std::size_t>(row)]);
    const Box box = scale.on_page(plan.pages[first].part);
    const std::string pages = columns == 1
                                  ? fmt::format("page {}", first + 2)
                                  : fmt::format("pages {}-{}", first + 2, first + 1 + columns);
    const double size = std::min(layout.scale * kTextMm, 0.5 * box.height_mm);
    draw::draw_text(canvas, fmt::format("row {}: {}", row + 1, pages), layout.map.x_mm,
                    box.y_mm + 0.5 * box.height_mm, 0.95 * (box.x_mm - layout.map.x_mm),
                    text_style(size));
    first += columns;
  }
}

void draw_map(draw::Canvas& canvas, const PosterPlan& plan, const MapLayout& layout) {
  const MapScale scale = map_scale(plan, layout);
  for (const PosterTag& tag : plan.tags) {
    const codec::TagCells cells =
        codec::tag_cells(tag.family->layout(), tag.family->codeword(tag.id));
    canvas.fill(draw::path_of(draw::black_outlines(cells)),
                draw::grid_placement(scale.on_page(plan.outer(tag)), cells.width()),
                {.gray = kTagGray, .role = draw::Role::Note});
  }
  Path pages;
  for (const PosterPage& page : plan.pages) {
    const Box box = scale.on_page(page.part);
    pages.add_rectangle(box.x_mm, box.y_mm, box.width_mm, box.height_mm);
  }
  const draw::Ink ink{.gray = kLineGray, .role = draw::Role::Note};
  canvas.stroke(pages, {}, {.width_mm = 0.15, .ink = ink});
  Path rim;
  const Box poster = scale.on_page({0, 0, plan.side_mm, plan.side_mm});
  rim.add_rectangle(poster.x_mm, poster.y_mm, poster.width_mm, poster.height_mm);
  canvas.stroke(rim, {}, {.width_mm = 0.4, .ink = ink});
  for (std::size_t i = 0; i < plan.pages.size(); ++i) {
    draw_number(canvas, plan, i, scale.on_page(plan.pages[i].part));
  }
  draw_rows(canvas, plan, layout, scale);
}

/// "6 of 210 mm x 297 mm" for each way that the paper lies.
std::string papers(const PosterPlan& plan) {
  std::vector<std::pair<std::string, int>> counts;
  for (const PosterPage& page : plan.pages) {
    const std::string paper = fmt::format("{} x {}", format_mm(plan.page_width_mm(page)),
                                          format_mm(plan.page_height_mm(page)));
    if (counts.empty() || counts.back().first != paper) counts.emplace_back(paper, 0);
    ++counts.back().second;
  }
  std::string text;
  for (const auto& [paper, count] : counts) {
    text += fmt::format("{}{} of {}", text.empty() ? "" : " and ", count, paper);
  }
  return text;
}

}  // namespace

std::vector<std::string> poster_facts(const PosterPlan& plan) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < plan.tags.size(); ++i) {
    const PosterTag& tag = plan.tags[i];
    lines.push_back(fmt::format("{} {}{}: edge {}, outer {}", tag.family->name(), tag.id,
                                i > 0 ? " in the hole" : "", format_mm(tag.edge_mm),
                                format_mm(plan.outer(tag).width_mm)));
  }
  lines.push_back(fmt::format("poster with its quiet zone: {0} x {0}", format_mm(plan.side_mm)));
  lines.push_back(fmt::format("pages: {}, overlap {}", papers(plan), format_mm(plan.overlap_mm)));
  const auto white = std::count_if(plan.pages.begin(), plan.pages.end(),
                                   [](const PosterPage& page) { return page.all_white; });
  if (white > 0) {
    lines.push_back(fmt::format("{} of them {} all white, counted and printed like the others",
                                white, white == 1 ? "is" : "are"));
  }
  return lines;
}

void draw_poster_map(draw::Canvas& canvas, const PosterPlan& plan) {
  const std::vector<std::string> facts = poster_facts(plan);
  const MapLayout layout = lay_out(plan, facts.size());
  const Box& area = layout.area;
  const double size = layout.scale * kTextMm;
  double baseline = area.y_mm + layout.scale * kTitleMm;
  draw::draw_text(canvas,
                  fmt::format("Poster: {} {}", plan.tags[0].family->name(), plan.tags[0].id),
                  area.x_mm, baseline, area.width_mm, text_style(layout.scale * kTitleMm));
  for (const std::string& line : facts) {
    baseline += layout.line_mm;
    draw::draw_text(canvas, line, area.x_mm, baseline, area.width_mm, text_style(size));
  }
  draw_map(canvas, plan, layout);
  baseline = layout.map.bottom_mm() + layout.scale * kSpaceMm;
  for (const std::string_view line : kHowTo) {
    baseline += layout.line_mm;
    draw::draw_text(canvas, std::string(line), area.x_mm, baseline, area.width_mm,
                    text_style(size));
  }
  const Box ruler = {area.x_mm, area.bottom_mm() - draw::kRulerDepthMm, area.width_mm,
                     draw::kRulerDepthMm};
  draw::draw_ruler(canvas, ruler, draw::RulerPlace::Lying, kTextGray);
}

}  // namespace tagmint::poster
