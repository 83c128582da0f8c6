#include "draw/cairo_surface.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <utility>

#include "draw/units.h"
#include "io/images.h"
#include "tagmint/codec/errors.h"

namespace tagmint::draw {
namespace {

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status == CAIRO_STATUS_INVALID_STRING) {
    throw std::invalid_argument("a title or label is not valid UTF-8");
  }
  throw codec::OutputError(fmt::format("the drawing failed: {}", cairo_status_to_string(status)),
                           "", "make the page or the number of tags smaller");
}

cairo_status_t append(void* sink, const unsigned char* data, unsigned int count) {
  try {
    static_cast<std::string*>(sink)->append(reinterpret_cast<const char*>(data), count);
  } catch (const std::exception&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
  return CAIRO_STATUS_SUCCESS;
}

/// Hands the pixels of a drawing in gray tones to the PNG writer.
std::string gray_png(cairo_surface_t* surface, double dpi) {
  cairo_surface_flush(surface);
  check(cairo_surface_status(surface));
  const int width = cairo_image_surface_get_width(surface);
  const int height = cairo_image_surface_get_height(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  const unsigned char* const pixels = cairo_image_surface_get_data(surface);
  detect::Image image(width, height);
  for (int y = 0; y < height; ++y) {
    // 32-bit words with the colour in the low 24 bits; gray has the same value in all three bytes.
    const auto* words = reinterpret_cast<const std::uint32_t*>(pixels + std::ptrdiff_t{y} * stride);
    std::uint8_t* const row = image.row(y);
    for (int x = 0; x < width; ++x) row[x] = static_cast<std::uint8_t>(words[x]);
  }
  return io::encode_png(image, dpi);
}

}  // namespace

CairoCanvas::CairoCanvas(SurfaceOwner surface, std::unique_ptr<std::string> stream,
                         double units_a_mm, std::optional<double> png_dpi)
    : stream_(std::move(stream)), surface_(std::move(surface)), png_dpi_(png_dpi) {
  check(cairo_surface_status(surface_.get()));
  context_.reset(cairo_create(surface_.get()));
  cairo_scale(context_.get(), units_a_mm, units_a_mm);
  check(cairo_status(context_.get()));
}

CairoCanvas CairoCanvas::pdf(double width_mm, double height_mm, const std::string& title) {
  auto stream = std::make_unique<std::string>();
  SurfaceOwner surface(cairo_pdf_surface_create_for_stream(
      append, stream.get(), width_mm * kPointsAMm, height_mm * kPointsAMm));
  if (!title.empty()) {
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
  }
  // No date, so that the same tags give the same file.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  return CairoCanvas(std::move(surface), std::move(stream), kPointsAMm, {});
}

CairoCanvas CairoCanvas::svg(double width_mm, double height_mm) {
  auto stream = std::make_unique<std::string>();
  // With this unit, Cairo's lengths are mm all through.
  SurfaceOwner surface(
      cairo_svg_surface_create_for_stream(append, stream.get(), width_mm, height_mm));
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_MM);
  return CairoCanvas(std::move(surface), std::move(stream), 1.0, {});
}

CairoCanvas CairoCanvas::png(double width_mm, double height_mm, double dpi) {
  const double scale = dpi / kMmAnInch;
  const double width = std::max(1.0, std::round(width_mm * scale));
  const double height = std::max(1.0, std::round(height_mm * scale));
  constexpr double kLargestSide = 32767;  // of Cairo's image surfaces
  if (width > kLargestSide || height > kLargestSide ||
      width * height > static_cast<double>(io::kMaxPixels)) {
    throw codec::OutputError(
        fmt::format("a picture of {:.0f} x {:.0f} pixels is too large; the limit is {:.0f} a side "
                    "and {} in all",
                    width, height, kLargestSide, io::kMaxPixels),
        fmt::format("{:g} dpi", dpi), "take fewer dots per inch, or write a PDF or SVG");
  }
  SurfaceOwner surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width),
                                                  static_cast<int>(height)));
  CairoCanvas canvas(std::move(surface), nullptr, scale, dpi);
  cairo_set_source_rgb(canvas.context(), 1, 1, 1);
  cairo_paint(canvas.context());
  return canvas;
}

void CairoCanvas::finish_page() {
  check(cairo_status(context_.get()));
  cairo_show_page(context_.get());
}

std::string CairoCanvas::finish() {
  check(cairo_status(context_.get()));
  context_.reset();
  if (png_dpi_) return gray_png(surface_.get(), *png_dpi_);
  cairo_surface_finish(surface_.get());
  check(cairo_surface_status(surface_.get()));
  return std::move(*stream_);
}

}  // namespace tagmint::draw
