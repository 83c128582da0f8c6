#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "draw/cairo_owners.h"
#include "draw/read_back_kinds.h"
#include "tagmint/codec/errors.h"

namespace tagmint::draw {

detect::Image drawn_page(double width_px, double height_px,
                         const std::function<void(cairo_t*)>& draw) {
  // A part of a pixel at the right and lower side is left out: pages end with white.
  const int width = std::max(1, static_cast<int>(std::round(width_px)));
  const int height = std::max(1, static_cast<int>(std::round(height_px)));
  const SurfaceOwner surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  check_cairo(cairo_surface_status(surface.get()));
  const ContextOwner context(cairo_create(surface.get()));
  cairo_set_source_rgb(context.get(), 1, 1, 1);
  cairo_paint(context.get());
  draw(context.get());
  check_cairo(cairo_status(context.get()));
  cairo_surface_flush(surface.get());
  const unsigned char* const pixels = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  detect::Image image(width, height);
  for (int y = 0; y < height; ++y) {
    // 32-bit words with the colour in the low 24 bits; gray has the same value in all three bytes.
    const auto* words = reinterpret_cast<const std::uint32_t*>(pixels + std::ptrdiff_t{y} * stride);
    std::uint8_t* const row = image.row(y);
    for (int x = 0; x < width; ++x) row[x] = static_cast<std::uint8_t>(words[x]);
  }
  return image;
}

void fail_to_read_back(const std::filesystem::path& path, const char* reason) {
  throw codec::OutputError(fmt::format("what was written cannot be read back: {}", reason),
                           path.string(), "write it again, or leave --verify out");
}

}  // namespace tagmint::draw
