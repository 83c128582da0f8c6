#include "draw/outline_canvas.h"

#include "draw/units.h"

namespace tagmint::draw {
namespace {

/// A thousandth of an inch: at or below this, drivers of laser cutters take a line for a cut.
constexpr double kHairlineMm = 0.001 * kMmAnInch;

}  // namespace

OutlineCanvas::OutlineCanvas(std::unique_ptr<Canvas> canvas) : canvas_(std::move(canvas)) {}

void OutlineCanvas::begin_page(const PageSetup& page) { canvas_->begin_page(page); }

void OutlineCanvas::paint_ground(const Path&) {}

void OutlineCanvas::fill(const Path& path, const Placement& place, const Ink& ink) {
  canvas_->stroke(path, place, {.width_mm = kHairlineMm, .ink = {.gray = 0.0, .role = ink.role}});
}

void OutlineCanvas::stroke(const Path& path, const Placement& place, const Pen& pen) {
  canvas_->stroke(path, place,
                  {.width_mm = kHairlineMm, .ink = {.gray = 0.0, .role = pen.ink.role}});
}

void OutlineCanvas::end_page() { canvas_->end_page(); }

void OutlineCanvas::finish() { canvas_->finish(); }

}  // namespace tagmint::draw
