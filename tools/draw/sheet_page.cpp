#include "draw/sheet_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

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
constexpr double kCutMarkLineMm = 0.1;

codec::TagCells cells_of(const TagGroup& group, codec::TagId id) {
  return codec::tag_cells(group.family->layout(), group.family->codeword(id));
}

/// In the band below the tag and its quiet zone, at whose lower end the slot ends.
void draw_label(cairo_t* context, const SheetPlan& plan, const PlacedTag& tag,
                const TextFormat& format) {
  const double height = plan.options.label_mm;
  // Capitals are 0.73 of the font's size, tails 0.24: this leaves 0.3 of the band free above them.
  const TextStyle style{.size_mm = 0.68 * height, .gray = kLabelGray, .align = TextAlign::Centre};
  const std::string text = format.expand(tag_fields(plan.groups[tag.group], tag.id, " "));
  draw_text(context, text, tag.slot.x_mm + tag.slot.width_mm / 2,
            tag.slot.bottom_mm() - 0.2 * height, tag.slot.width_mm, style);
}

/// Two short lines at each corner of a slot, which continue its sides outwards.
void draw_cut_marks(cairo_t* context, const Box& slot, double gap_mm) {
  // Less than half a gap, so that marks of neighbours stay apart and outside each other's slots.
  const double length = std::min(kCutMarkMm, 0.42 * gap_mm);
  for (const double x : {slot.x_mm, slot.right_mm()}) {
    for (const double y : {slot.y_mm, slot.bottom_mm()}) {
      const double right = x > slot.x_mm ? 1.0 : -1.0;
      const double down = y > slot.y_mm ? 1.0 : -1.0;
      // A tenth of the length stays free at the corner, so that no ink touches the tag's paper.
      cairo_move_to(context, x + right * 0.1 * length, y);
      cairo_line_to(context, x + right * length, y);
      cairo_move_to(context, x, y + down * 0.1 * length);
      cairo_line_to(context, x, y + down * length);
    }
  }
  cairo_set_line_width(context, kCutMarkLineMm);
  cairo_set_source_rgb(context, kMarkGray, kMarkGray, kMarkGray);
  cairo_stroke(context);
}

void draw_title(cairo_t* context, const Box& area, const std::string& title) {
  draw_text(context, title, area.x_mm + area.width_mm / 2, area.y_mm + kTitleSizeMm, area.width_mm,
            {.size_mm = kTitleSizeMm, .gray = kLabelGray, .align = TextAlign::Centre});
}

std::set<std::size_t> groups_on(const SheetPage& page) {
  std::set<std::size_t> groups;
  for (const PlacedTag& tag : page.tags) groups.insert(tag.group);
  return groups;
}

/// One line for each kind of tag on the page, and on the right how to print and the page's number.
void draw_notes(cairo_t* context, const SheetPlan& plan, std::size_t page) {
  const Box area = plan.area();
  const std::set<std::size_t> shown = groups_on(plan.pages[page]);
  double baseline = area.bottom_mm() - kNoteLineMm * (static_cast<double>(shown.size()) - 1) - 0.8;
  const TextStyle left{.size_mm = kNoteSizeMm, .gray = kNoteGray, .align = TextAlign::Left};
  const TextStyle right{.size_mm = kNoteSizeMm, .gray = kNoteGray, .align = TextAlign::Right};
  for (const std::size_t index : shown) {
    const TagGroup& group = plan.groups[index];
    const double outer = outer_of_edge(group.family->layout(), group.edge_mm);
    draw_text(context,
              fmt::format("{}: edge {}, outer {}", group.family->name(), format_mm(group.edge_mm),
                          format_mm(outer)),
              area.x_mm, baseline, 0.55 * area.width_mm, left);
    baseline += kNoteLineMm;
  }
  std::string note = "print at 100 %, not fitted to the page";
  if (plan.pages.size() > 1) note += fmt::format("  |  page {} of {}", page + 1, plan.pages.size());
  draw_text(context, note, area.right_mm(), area.bottom_mm() - 0.8, 0.43 * area.width_mm, right);
}

}  // namespace

void draw_page(cairo_t* context, const SheetPlan& plan, std::size_t page, const SheetDecor& decor) {
  const Box area = plan.area();
  if (!decor.title.empty()) draw_title(context, area, decor.title);
  for (const PlacedTag& tag : plan.pages[page].tags) {
    draw_tag(context, cells_of(plan.groups[tag.group], tag.id), tag.outer);
    if (decor.label) draw_label(context, plan, tag, *decor.label);
    if (decor.cut_marks) draw_cut_marks(context, tag.slot, plan.options.gap_mm);
  }
  if (decor.ruler) {
    const double lines =
        decor.notes ? static_cast<double>(groups_on(plan.pages[page]).size()) : 0.0;
    draw_ruler(context, area.x_mm, area.bottom_mm() - lines * kNoteLineMm - kRulerHeightMm,
               area.width_mm, kNoteGray);
  }
  if (decor.notes) draw_notes(context, plan, page);
}

void draw_paper(cairo_t* context, const SheetPlan& plan, std::size_t page) {
  cairo_new_path(context);
  cairo_rectangle(context, 0, 0, plan.options.page_width_mm, plan.options.page_height_mm);
  for (const PlacedTag& tag : plan.pages[page].tags) {
    const codec::TagCells cells = cells_of(plan.groups[tag.group], tag.id);
    add_outlines(context, hole_outlines(cells), cells.width(), tag.outer);
  }
  cairo_set_fill_rule(context, CAIRO_FILL_RULE_EVEN_ODD);
  cairo_set_source_rgb(context, 1, 1, 1);
  cairo_fill(context);
  cairo_set_fill_rule(context, CAIRO_FILL_RULE_WINDING);
}

}  // namespace tagmint::draw
