#include "draw/sheet_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "draw/units.h"

namespace tagmint::draw {
namespace {

// Sums of lengths are compared with this much room for rounding: a nanometre, nothing a printer
// could show.
constexpr double kSlackMm = 1e-6;

void require(bool holds, const char* what, double value, const char* range) {
  if (!holds) {
    throw std::invalid_argument(fmt::format("{} of {} cannot be; it is {}", what, value, range));
  }
}

void check(const std::vector<TagGroup>& groups, const SheetOptions& options) {
  for (const double side : {options.page_width_mm, options.page_height_mm}) {
    require(side > 0 && side <= kMaxPageMm, "a page side in mm", side, "above 0 up to 5080");
  }
  for (const double length : {options.margin_mm, options.gap_mm, options.label_mm,
                              options.header_mm, options.footer_mm, options.side_mm}) {
    require(length >= 0, "a margin, gap or text height in mm", length, "0 or more");
  }
  require(options.quiet_zone_cells >= 0, "a quiet zone in cells", options.quiet_zone_cells,
          "0 or more");
  require(options.dot_mm >= 0, "the width of a dot in mm", options.dot_mm, "0 or more");
  require(options.columns >= 0, "a number of columns", options.columns, "0 or more");
  require(options.rows >= 0, "a number of rows", options.rows, "0 or more");
  if (groups.empty()) throw std::invalid_argument("a sheet needs at least one group of tags");
  for (const TagGroup& group : groups) {
    if (!group.family) throw std::invalid_argument("a group of tags needs a family");
    if (group.ids.empty()) throw std::invalid_argument("a group of tags needs at least one id");
    require(std::isfinite(group.edge_mm) && group.edge_mm > 0, "an edge in mm", group.edge_mm,
            "above 0");
    for (const codec::TagId id : group.ids) {
      require(id < group.family->size(), "an id", id, "one of the family's");
    }
  }
}

/// The lengths of a group's slots.
struct SlotSize {
  double outer_mm;
  double quiet_mm;   // around the tag
  double offset_mm;  // from the slot's left and upper side to the tag
  double width_mm;
  double height_mm;
};

SlotSize slot_size(const TagGroup& group, const SheetOptions& options) {
  const codec::Layout& layout = group.family->layout();
  const double outer = outer_of_edge(layout, group.edge_mm);
  const double quiet = quiet_zone_mm(layout, group.edge_mm, options.quiet_zone_cells);
  double side = outer + 2 * quiet;
  if (options.cut_shape == CutShape::Circle) {
    const double cell = group.edge_mm / layout.width_at_border();
    side = std::max(side, 2 * (radius_cells(layout) * cell + quiet));
  }
  return {outer, quiet, (side - outer) / 2, side, side + options.label_mm};
}

/// How many slots of `slot` mm, `gap` apart, stand within `room`.
int fit(double room, double slot, double gap) {
  const double count = std::floor((room + gap + kSlackMm) / (slot + gap));
  return static_cast<int>(std::clamp(count, 0.0, 1e6));
}

double span(int count, double slot, double gap) { return count * slot + (count - 1) * gap; }

std::string describe(const TagGroup& group) {
  return fmt::format("{} with edge {}", group.family->name(), format_mm(group.edge_mm));
}

/// The number of columns or rows: what was asked for, or what fits.
int grid_count(int asked, double room, double slot, double gap, const char* what,
               const TagGroup& group) {
  const int most = fit(room, slot, gap);
  if (most < 1) {
    throw DoesNotFit(
        fmt::format("not one tag fits on the page: it needs {} of {} with its quiet zone and "
                    "label, and {} are free",
                    format_mm(slot), what, format_mm(std::max(room, 0.0))),
        describe(group), "take a larger paper, a smaller margin or a smaller edge");
  }
  if (asked > most) {
    throw DoesNotFit(
        fmt::format("{} tags do not fit in the {} of the page: they need {}, and {} are free",
                    asked, what, format_mm(span(asked, slot, gap)), format_mm(room)),
        describe(group), fmt::format("ask for at most {}", most));
  }
  return asked > 0 ? asked : most;
}

/// Fills pages with rows from top to bottom; y is counted from the top of the room.
class PageFiller {
 public:
  PageFiller(SheetPlan& plan, double height_mm) : plan_(plan), height_mm_(height_mm) {}

  void add_group(std::size_t index);
  /// Height of the fullest page.
  double tallest_mm() const { return tallest_mm_; }

 private:
  void start_page() {
    plan_.pages.emplace_back();
    y_mm_ = 0.0;
    rows_ = 0;
  }

  SheetPlan& plan_;
  double height_mm_;
  double y_mm_ = 0.0;  // where the next row begins
  int rows_ = 0;       // on this page, of all groups
  double tallest_mm_ = 0.0;
};

void PageFiller::add_group(std::size_t index) {
  const SheetOptions& options = plan_.options;
  const TagGroup& group = plan_.groups[index];
  const SlotSize slot = slot_size(group, options);
  Box area = plan_.area();
  area.x_mm += options.side_mm;
  area.width_mm -= options.side_mm;
  const int columns =
      grid_count(options.columns, area.width_mm, slot.width_mm, options.gap_mm, "width", group);
  const int rows =
      grid_count(options.rows, height_mm_, slot.height_mm, options.gap_mm, "height", group);
  plan_.grids.push_back({columns, rows});

  // Few tags are centred as they are; a full grid keeps its columns to the last row.
  const int used =
      static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(columns), group.ids.size()));
  const double left = area.x_mm + (area.width_mm - span(used, slot.width_mm, options.gap_mm)) / 2;
  for (std::size_t i = 0; i < group.ids.size(); ++i) {
    const int column = static_cast<int>(i % static_cast<std::size_t>(used));
    if (column == 0) {
      if (i > 0 || rows_ > 0) y_mm_ += options.gap_mm;
      const bool full = y_mm_ + slot.height_mm > height_mm_ + kSlackMm ||
                        (options.rows > 0 && rows_ == options.rows);
      if (plan_.pages.empty() || full) start_page();
      y_mm_ += slot.height_mm;
      ++rows_;
      tallest_mm_ = std::max(tallest_mm_, y_mm_);
    }
    const double x = left + column * (slot.width_mm + options.gap_mm);
    const double y = y_mm_ - slot.height_mm;
    plan_.pages.back().tags.push_back(
        {.group = index,
         .id = group.ids[i],
         .outer = {x + slot.offset_mm, y + slot.offset_mm, slot.outer_mm, slot.outer_mm},
         .slot = {x, y, slot.width_mm, slot.height_mm},
         .quiet_mm = slot.quiet_mm});
  }
}

/// Moves a tag down by `top_mm`, then to the nearest place that is a whole number of dots.
void move(PlacedTag& tag, double top_mm, double dot_mm) {
  const auto to_dot = [&](double at) {
    return dot_mm > 0 ? std::round(at / dot_mm) * dot_mm - at : 0.0;
  };
  const double right = to_dot(tag.outer.x_mm);
  const double down = top_mm + to_dot(tag.outer.y_mm + top_mm);
  for (Box* box : {&tag.outer, &tag.slot}) {
    box->x_mm += right;
    box->y_mm += down;
  }
}

}  // namespace

double outer_of_edge(const codec::Layout& layout, double edge_mm) {
  return edge_mm * layout.width() / layout.width_at_border();
}

double edge_of_outer(const codec::Layout& layout, double outer_mm) {
  return outer_mm * layout.width_at_border() / layout.width();
}

int quiet_cells(const codec::Layout& layout) {
  const int last = layout.width() - 1;
  for (int i = 0; i <= last; ++i) {
    // A layout looks the same after a quarter turn: one side tells of all four.
    if (layout.cell(i, 0) != codec::Cell::White) return 1;
  }
  return 0;
}

double quiet_zone_mm(const codec::Layout& layout, double edge_mm, double quiet_zone_cells) {
  const double own_ring = quiet_cells(layout) == 0 ? 1.0 : 0.0;
  return std::max(0.0, quiet_zone_cells - own_ring) * edge_mm / layout.width_at_border();
}

double radius_cells(const codec::Layout& layout) {
  const double middle = layout.width() / 2.0;
  double radius = 0.0;
  for (int y = 0; y < layout.width(); ++y) {
    for (int x = 0; x < layout.width(); ++x) {
      if (layout.cell(x, y) == codec::Cell::None) continue;
      // The farther side of the cell in each direction.
      const double dx = std::max(middle - x, x + 1 - middle);
      const double dy = std::max(middle - y, y + 1 - middle);
      radius = std::max(radius, std::hypot(dx, dy));
    }
  }
  return radius;
}

double whole_dot_edge(const codec::Layout& layout, double edge_mm, double dpi) {
  const double dot_mm = kMmAnInch / dpi;
  const double dots = std::max(1.0, std::round(edge_mm / layout.width_at_border() / dot_mm));
  return dots * dot_mm * layout.width_at_border();
}

Box SheetPlan::area() const {
  return {options.margin_mm, options.margin_mm, options.page_width_mm - 2 * options.margin_mm,
          options.page_height_mm - 2 * options.margin_mm};
}

std::size_t SheetPlan::tag_count() const {
  std::size_t count = 0;
  for (const SheetPage& page : pages) count += page.tags.size();
  return count;
}

SheetPlan plan_sheet(std::vector<TagGroup> groups, const SheetOptions& options) {
  check(groups, options);
  SheetPlan plan{.options = options, .groups = std::move(groups), .grids = {}, .pages = {}};
  const double room = plan.area().height_mm - options.header_mm - options.footer_mm;
  PageFiller filler(plan, room);
  for (std::size_t i = 0; i < plan.groups.size(); ++i) filler.add_group(i);

  const double top = options.margin_mm + options.header_mm + (room - filler.tallest_mm()) / 2;
  for (SheetPage& page : plan.pages) {
    for (PlacedTag& tag : page.tags) move(tag, top, options.dot_mm);
  }
  return plan;
}

SheetPlan plan_single(const codec::SharedFamily& family, double edge_mm, codec::TagId id,
                      SheetOptions options) {
  std::vector<TagGroup> groups = {{family, edge_mm, {id}}};
  options.columns = options.rows = 1;
  options.header_mm = options.footer_mm = options.side_mm = 0.0;
  options.page_width_mm = options.page_height_mm = 1.0;
  check(groups, options);
  const SlotSize slot = slot_size(groups[0], options);
  options.page_width_mm = slot.width_mm + 2 * options.margin_mm;
  options.page_height_mm = slot.height_mm + 2 * options.margin_mm;
  if (options.page_height_mm > kMaxPageMm || options.page_width_mm > kMaxPageMm) {
    throw DoesNotFit(fmt::format("a page of {} is larger than the limit of {}",
                                 format_mm(options.page_height_mm), format_mm(kMaxPageMm)),
                     describe(groups[0]), "take a smaller edge");
  }
  return plan_sheet(std::move(groups), options);
}

}  // namespace tagmint::draw
