#include "draw/raster_canvas.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "draw/cairo_owners.h"
#include "draw/units.h"
#include "io/row_writer.h"
#include "tagmint/codec/errors.h"

namespace tagmint::draw {
namespace {

constexpr double kLargestSide = 32767;         // of Cairo's image surfaces
constexpr double kMostPixels = 4294967295.0;   // readers count pixels in 32 bits
constexpr std::int64_t kBandPixels = 1 << 22;  // drawn at once

void append_path(cairo_t* context, const Path& path, const Placement& place) {
  for_each_step(path, [&](Path::Step step, const PathPoint* points) {
    const auto at = [&](int i) { return place.on_page(points[i]); };
    switch (step) {
      case Path::Step::Move:
        return cairo_move_to(context, at(0).x, at(0).y);
      case Path::Step::Line:
        return cairo_line_to(context, at(0).x, at(0).y);
      case Path::Step::Curve:
        return cairo_curve_to(context, at(0).x, at(0).y, at(1).x, at(1).y, at(2).x, at(2).y);
      case Path::Step::Close:
        return cairo_close_path(context);
    }
  });
}

}  // namespace

RasterCanvas::RasterCanvas(ByteSink sink, Kind kind, const Options& options)
    : sink_(std::move(sink)), kind_(kind), options_(options) {}

void RasterCanvas::begin_page(const PageSetup& page) {
  if (width_ > 0) throw std::logic_error("a PNG or TIFF file holds one page");
  const double scale = options_.dpi / kMmAnInch;
  const double width = std::max(1.0, std::round(page.width_mm * scale));
  const double height = std::max(1.0, std::round(page.height_mm * scale));
  if (width > kLargestSide || height > kMostPixels / width) {
    throw codec::OutputError(
        fmt::format(
            "a picture of {:.0f} x {:.0f} pixels is too large; the limit is {:.0f} in width "
            "and {:.0f} in all",
            width, height, kLargestSide, kMostPixels),
        fmt::format("{:g} dpi", options_.dpi), "take fewer dots per inch, or write a PDF or SVG");
  }
  width_ = static_cast<int>(width);
  height_ = static_cast<int>(height);
}

void RasterCanvas::add(const Path& path, const Placement& place, double pen_mm, double gray) {
  if (gray >= 1 || path.empty()) return;
  const PathBounds box = bounds(path);
  const double scale = options_.dpi / kMmAnInch;
  constexpr double kMitre = 10.0;  // Cairo's limit: how far a corner reaches, in half pens
  const double reach = kMitre * pen_mm / 2;
  marks_.push_back({.path = path,
                    .place = place,
                    .pen_mm = pen_mm,
                    .opacity = options_.bits == 1 ? 1.0 : 1.0 - gray,
                    .top_px = (place.on_page({0, box.top}).y - reach) * scale - 1,
                    .bottom_px = (place.on_page({0, box.bottom}).y + reach) * scale + 1});
}

void RasterCanvas::paint_ground(const Path&) {}

void RasterCanvas::fill(const Path& path, const Placement& place, const Ink& ink) {
  add(path, place, 0.0, ink.gray);
}

void RasterCanvas::stroke(const Path& path, const Placement& place, const Pen& pen) {
  add(path, place, pen.width_mm, pen.ink.gray);
}

void RasterCanvas::end_page() {
  const io::RowFormat format{.width = width_,
                             .height = height_,
                             .bits = options_.bits,
                             .transparent = options_.transparent,
                             .dpi = options_.dpi};
  const auto writer =
      kind_ == Kind::Png ? io::png_row_writer(format, sink_) : io::tiff_row_writer(format, sink_);
  const int band =
      static_cast<int>(std::clamp<std::int64_t>(kBandPixels / width_, 1, std::min(height_, 32767)));
  const SurfaceOwner surface(cairo_image_surface_create(CAIRO_FORMAT_A8, width_, band));
  check_cairo(cairo_surface_status(surface.get()));
  std::vector<std::uint8_t> row(static_cast<std::size_t>(width_));
  for (int top = 0; top < height_; top += band) {
    // Cairo's surfaces of this kind hold how much ink there is.
    unsigned char* const ink = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    std::memset(ink, 0, static_cast<std::size_t>(stride) * static_cast<std::size_t>(band));
    cairo_surface_mark_dirty(surface.get());
    const ContextOwner context(cairo_create(surface.get()));
    cairo_translate(context.get(), 0, -top);
    cairo_scale(context.get(), options_.dpi / kMmAnInch, options_.dpi / kMmAnInch);
    for (const Mark& mark : marks_) {
      if (mark.bottom_px < top || mark.top_px > top + band) continue;
      cairo_set_source_rgba(context.get(), 0, 0, 0, mark.opacity);
      append_path(context.get(), mark.path, mark.place);
      if (mark.pen_mm > 0) {
        cairo_set_line_width(context.get(), mark.pen_mm);
        cairo_stroke(context.get());
      } else {
        cairo_fill(context.get());
      }
    }
    check_cairo(cairo_status(context.get()));
    cairo_surface_flush(surface.get());
    for (int y = 0; y < std::min(band, height_ - top); ++y) {
      const unsigned char* const source = ink + std::ptrdiff_t{y} * stride;
      std::transform(source, source + width_, row.begin(),
                     [](unsigned char level) { return static_cast<std::uint8_t>(255 - level); });
      writer->write(row);
    }
  }
  writer->finish();
  marks_.clear();
}

void RasterCanvas::finish() {}

}  // namespace tagmint::draw
