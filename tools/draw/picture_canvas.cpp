#include "draw/picture_canvas.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "tagmint/codec/errors.h"

namespace tagmint::draw {
namespace {

using detect::Point;

/// The bytes of row y. Each pixel is a 32-bit word 0x00RRGGBB in the machine's byte order.
unsigned char* row_of(cairo_surface_t* surface, int y) {
  return cairo_image_surface_get_data(surface) +
         static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface);
}

void require_success(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw codec::OutputError("the picture cannot be drawn", cairo_status_to_string(status),
                             "use a smaller image");
  }
}

void copy_gray(const detect::ImageView& picture, double brightness, cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  for (int y = 0; y < picture.height; ++y) {
    unsigned char* row = row_of(surface, y);
    for (int x = 0; x < picture.width; ++x) {
      const auto level = static_cast<std::uint32_t>(std::lround(brightness * picture.at(x, y)));
      const std::uint32_t word = level * 0x010101U;
      std::memcpy(row + 4 * static_cast<std::ptrdiff_t>(x), &word, sizeof word);
    }
  }
  cairo_surface_mark_dirty(surface);
}

}  // namespace

PictureCanvas::PictureCanvas(const detect::ImageView& picture, double brightness)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width, picture.height)) {
  require_success(cairo_surface_status(surface_.get()));
  copy_gray(picture, brightness, surface_.get());
  context_.reset(cairo_create(surface_.get()));
  require_success(cairo_status(context_.get()));
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
  cairo_select_font_face(context_.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_BOLD);
}

void PictureCanvas::set_colour(const Colour& colour, double opacity) {
  cairo_set_source_rgba(context_.get(), colour.red, colour.green, colour.blue, opacity);
}

void PictureCanvas::outline(const detect::Corners& corners, double width_px) {
  cairo_t* context = context_.get();
  cairo_new_path(context);
  for (const Point p : corners) cairo_line_to(context, p.x, p.y);
  cairo_close_path(context);
  cairo_set_line_width(context, width_px);
  cairo_stroke(context);
}

void PictureCanvas::line(Point from, Point to, double width_px) {
  cairo_t* context = context_.get();
  cairo_new_path(context);
  cairo_move_to(context, from.x, from.y);
  cairo_line_to(context, to.x, to.y);
  cairo_set_line_width(context, width_px);
  cairo_stroke(context);
}

void PictureCanvas::disc(Point centre, double radius_px) {
  cairo_t* context = context_.get();
  cairo_new_path(context);
  cairo_arc(context, centre.x, centre.y, radius_px, 0, 2 * std::numbers::pi);
  cairo_fill(context);
}

void PictureCanvas::label(Point centre, double height_px, const std::string& text) {
  cairo_t* context = context_.get();
  cairo_set_font_size(context, height_px);
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  const double pad = 0.25 * height_px;
  const double left = centre.x - extents.width / 2;
  const double top = centre.y - extents.height / 2;
  cairo_new_path(context);
  cairo_rectangle(context, left - pad, top - pad, extents.width + 2 * pad,
                  extents.height + 2 * pad);
  cairo_set_source_rgba(context, 0, 0, 0, 0.65);
  cairo_fill(context);
  cairo_move_to(context, left - extents.x_bearing, top - extents.y_bearing);
  cairo_set_source_rgb(context, 1, 1, 1);
  cairo_show_text(context, text.c_str());
}

io::RgbImage PictureCanvas::picture() const {
  require_success(cairo_status(context_.get()));
  cairo_surface_t* surface = surface_.get();
  cairo_surface_flush(surface);
  io::RgbImage image(cairo_image_surface_get_width(surface),
                     cairo_image_surface_get_height(surface));
  for (int y = 0; y < image.height; ++y) {
    const unsigned char* row = row_of(surface, y);
    for (int x = 0; x < image.width; ++x) {
      std::uint32_t word = 0;
      std::memcpy(&word, row + 4 * static_cast<std::ptrdiff_t>(x), sizeof word);
      std::uint8_t* pixel = image.pixel(x, y);
      pixel[0] = static_cast<std::uint8_t>(word >> 16);
      pixel[1] = static_cast<std::uint8_t>(word >> 8);
      pixel[2] = static_cast<std::uint8_t>(word);
    }
  }
  return image;
}

}  // namespace tagmint::draw
