#include "draw/sheet_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "draw/cut_outline.h"
#include "draw/draw_tag.h"
#include "draw/ruler.h"
#include "draw/text.h"
#include "draw/units.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::draw {
namespace {

// Grays of what is not a tag: readable, and far enough from black to be no part of one.
constexpr double kLabelGray = 0.25;
constexpr double kNoteGray = 0.5;
constexpr double kMarkGray = 0.4;

constexpr double kTitleSizeMm = 5.0;
constexpr double kNoteSizeMm = 2.6;
constexpr double kCutMarkMm = 4.0;

codec::TagCells cells_of(const TagGroup& group, codec::TagId id) {
  return codec::tag_cells(group.family->layout(), group.family->codeword(id));
}

void draw_tag_of(Canvas& canvas, const SheetPlan& plan, const PlacedTag& tag, bool inverted) {
  const TagGroup& group = plan.groups[tag.group];
  const codec::TagCells cells = cells_of(group, tag.id);
  if (inverted) {
    draw_inverted_tag(canvas, group.family->layout(), cells, tag.outer, tag.quiet_mm,
                      plan.options.cut_shape == CutShape::Circle);
  } else {
    draw_tag(canvas, cells, tag.outer);
  }
}

/// In the band below the tag and its quiet zone, at whose lower end the slot ends.
void draw_label(Canvas& canvas, const SheetPlan& plan, const PlacedTag& tag,
                const TextFormat& format) {
  const double height = plan.options.label_mm;
  // Capitals are 0.73 of the font's size, tails 0.24: this leaves 0.3 of the band free above them.
  const TextStyle style{.size_mm = 0.68 * height,
                        .ink = {.gray = kLabelGray, .role = Role::Label},
                        .align = TextAlign::Centre};
  const std::string text = format.expand(tag_fields(plan.groups[tag.group], tag.id, " "));
  draw_text(canvas, text, tag.slot.x_mm + tag.slot.width_mm / 2,
            tag.slot.bottom_mm() - 0.2 * height, tag.slot.width_mm, style);
}

/// Two short lines at each corner of a slot, which continue its sides outwards.
void draw_cut_marks(Canvas& canvas, const Box& slot, double gap_mm) {
  // Less than half a gap, so that marks of neighbours stay apart and outside each other's slots.
  const double length = std::min(kCutMarkMm, 0.42 * gap_mm);
  Path marks;
  for (const double x : {slot.x_mm, slot.right_mm()}) {
    for (const double y : {slot.y_mm, slot.bottom_mm()}) {
      const double right = x > slot.x_mm ? 1.0 : -1.0;
      const double down = y > slot.y_mm ? 1.0 : -1.0;
      // A tenth of the length stays free at the corner, so that no ink touches the tag's paper.
      marks.add_line(x + right * 0.1 * length, y, x + right * length, y);
      marks.add_line(x, y + down * 0.1 * length, x, y + down * length);
    }
  }
  canvas.stroke(marks, {}, {.width_mm = kCutLineMm, .ink = {.gray = kMarkGray, .role = Role::Cut}});
}

void draw_cut_line(Canvas& canvas, const SheetPlan& plan, const PlacedTag& tag) {
  const SheetOptions& options = plan.options;
  const codec::Layout& layout = plan.groups[tag.group].family->layout();
  canvas.stroke(cut_outline(tag, layout, options.cut_shape, options.gap_mm), {},
                {.width_mm = kCutLineMm, .ink = {.gray = kMarkGray, .role = Role::Cut}});
}

void draw_title(Canvas& canvas, const Box& area, const std::string& title) {
  draw_text(canvas, title, area.x_mm + area.width_mm / 2, area.y_mm + kTitleSizeMm, area.width_mm,
            {.size_mm = kTitleSizeMm,
             .ink = {.gray = kLabelGray, .role = Role::Note},
             .align = TextAlign::Centre});
}

std::set<std::size_t> groups_on(const SheetPage& page) {
  std::set<std::size_t> groups;
  for (const PlacedTag& tag : page.tags) groups.insert(tag.group);
  return groups;
}

/// One line for each kind of tag on the page, and on the right how to print and the page's number.
void draw_notes(Canvas& canvas, const SheetPlan& plan, std::size_t page) {
  const Box area = plan.area();
  const std::set<std::size_t> shown = groups_on(plan.pages[page]);
  double baseline = area.bottom_mm() - kNoteLineMm * (static_cast<double>(shown.size()) - 1) - 0.8;
  const Ink ink{.gray = kNoteGray, .role = Role::Note};
  const TextStyle left{.size_mm = kNoteSizeMm, .ink = ink, .align = TextAlign::Left};
  const TextStyle right{.size_mm = kNoteSizeMm, .ink = ink, .align = TextAlign::Right};
  for (const std::size_t index : shown) {
    const TagGroup& group = plan.groups[index];
    const double outer = outer_of_edge(group.family->layout(), group.edge_mm);
    draw_text(canvas,
              fmt::format("{}: edge {}, outer {}", group.family->name(), format_mm(group.edge_mm),
                          format_mm(outer)),
              area.x_mm, baseline, 0.55 * area.width_mm, left);
    baseline += kNoteLineMm;
  }
  std::string note = "print at 100 %, not fitted to the page";
  if (plan.pages.size() > 1) note += fmt::format("  |  page {} of {}", page + 1, plan.pages.size());
  draw_text(canvas, note, area.right_mm(), area.bottom_mm() - 0.8, 0.43 * area.width_mm, right);
}

/// What is kept free for the ruler.
Box ruler_box(const SheetPlan& plan, std::size_t page, const SheetDecor& decor) {
  const Box area = plan.area();
  const auto lines = static_cast<double>(decor.notes ? groups_on(plan.pages[page]).size() : 0);
  const double bottom = area.bottom_mm() - lines * kNoteLineMm;
  if (decor.ruler == RulerPlace::Upright) {
    const double top = area.y_mm + header_height_mm(decor);
    return {area.x_mm, top, kRulerDepthMm, bottom - top};
  }
  return {area.x_mm, bottom - kRulerDepthMm, area.width_mm, kRulerDepthMm};
}

}  // namespace

void draw_page(Canvas& canvas, const SheetPlan& plan, std::size_t page, const SheetDecor& decor) {
  const Box area = plan.area();
  const std::vector<PlacedTag>& tags = plan.pages[page].tags;
  // Kind by kind, so that files with groups have one of each.
  for (const PlacedTag& tag : tags) draw_tag_of(canvas, plan, tag, decor.inverted);
  for (const PlacedTag& tag : tags) {
    if (decor.label) draw_label(canvas, plan, tag, *decor.label);
  }
  for (const PlacedTag& tag : tags) {
    if (decor.cut_marks) draw_cut_marks(canvas, tag.slot, plan.options.gap_mm);
    if (decor.cut_lines) draw_cut_line(canvas, plan, tag);
  }
  if (!decor.title.empty()) draw_title(canvas, area, decor.title);
  draw_ruler(canvas, ruler_box(plan, page, decor), decor.ruler, kNoteGray);
  if (decor.notes) draw_notes(canvas, plan, page);
}

Path paper_of(const SheetPlan& plan, std::size_t page) {
  Path paper;
  paper.add_rectangle(0, 0, plan.options.page_width_mm, plan.options.page_height_mm);
  for (const PlacedTag& tag : plan.pages[page].tags) {
    const codec::TagCells cells = cells_of(plan.groups[tag.group], tag.id);
    const Placement place = grid_placement(tag.outer, cells.width());
    // The other way round than the paper: holes in it.
    for (const Outline& outline : hole_outlines(cells)) {
      std::vector<PathPoint> corners;
      for (auto corner = outline.rbegin(); corner != outline.rend(); ++corner) {
        corners.push_back(place.on_page({double(corner->x), double(corner->y)}));
      }
      paper.add_polygon(corners);
    }
  }
  return paper;
}

}  // namespace tagmint::draw
