#include "support/sheet_measure.h"

#include <algorithm>
#include <cmath>

#include "draw/units.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::test {
namespace {

using codec::Cell;

constexpr int kInk = 250;  // below: not white

/// A tag on a picture.
struct PrintedTag {
  detect::ImageView picture;
  double scale;  // pixels a mm
  codec::TagCells cells;
  draw::PlacedTag place;

  double cell_px() const { return place.outer.width_mm * scale / cells.width(); }
  double left_px() const { return place.outer.x_mm * scale; }
  double top_px() const { return place.outer.y_mm * scale; }
  bool is_black(int x, int y) const {
    return x >= 0 && y >= 0 && x < cells.width() && y < cells.width() &&
           cells.at(x, y) == Cell::Black;
  }
  /// Gray of the pixel at a place; white outside the picture.
  int gray(double x_px, double y_px) const {
    const int x = static_cast<int>(std::floor(x_px));
    const int y = static_cast<int>(std::floor(y_px));
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return 255;
    return picture.at(x, y);
  }
};

/// Length of the black part between two places on a row or column, in pixels: the sum of what each
/// pixel holds of it.
double dark_length(const PrintedTag& tag, double from, double to, double across, bool along_x) {
  double dark = 0;
  for (double at = std::floor(from); at < to; at += 1) {
    const double part = std::min(at + 1, to) - std::max(at, from);
    const int gray = along_x ? tag.gray(at, across) : tag.gray(across, at);
    dark += part * (255 - gray) / 255.0;
  }
  return dark;
}

/// Edges between neighbouring cells of one row (or column), from the middle of one cell to the
/// middle of the next. The middle of a cell beyond the rim is on the paper.
void measure_edges(const PrintedTag& tag, int line, bool along_x, SheetMeasures& out) {
  const double cell = tag.cell_px();
  const double start = along_x ? tag.left_px() : tag.top_px();
  const double across = (along_x ? tag.top_px() : tag.left_px()) + (line + 0.5) * cell;
  for (int i = 0; i <= tag.cells.width(); ++i) {
    const bool before = along_x ? tag.is_black(i - 1, line) : tag.is_black(line, i - 1);
    const bool after = along_x ? tag.is_black(i, line) : tag.is_black(line, i);
    if (before == after) continue;
    const double edge = start + i * cell;
    const double dark = dark_length(tag, edge - cell / 2, edge + cell / 2, across, along_x);
    ++out.edges;
    out.largest_error_mm = std::max(out.largest_error_mm, std::abs(dark - cell / 2) / tag.scale);
  }
}

void measure_cells(const PrintedTag& tag, SheetMeasures& out) {
  for (int y = 0; y < tag.cells.width(); ++y) {
    for (int x = 0; x < tag.cells.width(); ++x) {
      const int gray = tag.gray(tag.left_px() + (x + 0.5) * tag.cell_px(),
                                tag.top_px() + (y + 0.5) * tag.cell_px());
      if (gray != (tag.is_black(x, y) ? 0 : 255)) ++out.wrong_cells;
    }
  }
}

/// Every pixel that is farther than a pixel from anything but black cells has to be black.
void measure_seams(const PrintedTag& tag, SheetMeasures& out) {
  const double side = tag.cell_px() * tag.cells.width();
  const auto cell_at = [&](double px) { return static_cast<int>(std::floor(px / tag.cell_px())); };
  const int top = static_cast<int>(tag.top_px());
  const int left = static_cast<int>(tag.left_px());
  for (int y = top; y < top + side; ++y) {
    for (int x = left; x < left + side; ++x) {
      bool inside = true;
      for (const double dy : {-1.0, 2.0}) {
        for (const double dx : {-1.0, 2.0}) {
          inside = inside &&
                   tag.is_black(cell_at(x + dx - tag.left_px()), cell_at(y + dy - tag.top_px()));
        }
      }
      if (inside && tag.gray(x, y) != 0) ++out.gray_in_black;
    }
  }
}

int count_ink(const PrintedTag& tag, double x0, double y0, double x1, double y1) {
  int count = 0;
  for (int y = static_cast<int>(std::ceil(y0)); y + 1 <= y1; ++y) {
    for (int x = static_cast<int>(std::ceil(x0)); x + 1 <= x1; ++x) {
      if (tag.gray(x, y) < kInk) ++count;
    }
  }
  return count;
}

/// The quiet zone, and the label band at the lower end of the slot.
void measure_surroundings(const PrintedTag& tag, double label_mm, SheetMeasures& out) {
  const draw::Box& slot = tag.place.slot;
  const double s = tag.scale;
  const double quiet = tag.place.quiet_mm * s;
  const double left = tag.left_px();
  const double right = tag.place.outer.right_mm() * s;
  const double top = tag.top_px();
  const double bottom = tag.place.outer.bottom_mm() * s;
  const double x0 = left - quiet;
  const double x1 = right + quiet;
  const double y0 = top - quiet;
  const double y1 = bottom + quiet;
  // Pixels beside the tag may hold a part of it.
  out.ink_in_quiet += count_ink(tag, x0, y0, x1, top - 1) + count_ink(tag, x0, bottom + 1, x1, y1) +
                      count_ink(tag, x0, y0, left - 1, y1) + count_ink(tag, right + 1, y0, x1, y1);
  if (label_mm <= 0) return;
  const double label_start = (slot.bottom_mm() - label_mm) * s;
  const double label_end = slot.bottom_mm() * s;
  const double slot_left = slot.x_mm * s;
  const double slot_right = slot.right_mm() * s;
  if (count_ink(tag, slot_left, label_start, slot_right, label_end) > 0) ++out.labels;
  constexpr double kFree = 0.15;  // share of the label's height above its tallest letters
  out.ink_at_labels_rim +=
      count_ink(tag, slot_left, label_start, slot_right, label_start + kFree * label_mm * s);
}

}  // namespace

SheetMeasures measure_page(const detect::ImageView& picture, double dpi,
                           const draw::SheetPlan& plan, std::size_t page) {
  SheetMeasures out;
  for (const draw::PlacedTag& place : plan.pages[page].tags) {
    const codec::Family& family = *plan.groups[place.group].family;
    const PrintedTag tag{picture, dpi / draw::kMmAnInch,
                         codec::tag_cells(family.layout(), family.codeword(place.id)), place};
    ++out.tags;
    for (int line = 0; line < tag.cells.width(); ++line) {
      measure_edges(tag, line, true, out);
      measure_edges(tag, line, false, out);
    }
    measure_cells(tag, out);
    measure_seams(tag, out);
    measure_surroundings(tag, plan.options.label_mm, out);
  }
  return out;
}

}  // namespace tagmint::test
