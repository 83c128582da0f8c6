#pragma once

#include <cairo.h>

#include <memory>
#include <string>

#include "draw/colour.h"
#include "io/images.h"
#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::draw {

/// Draws lines and text over a picture with Cairo, in the pixel coordinates of ImageView.
class PictureCanvas {
 public:
  /// Starts from a gray picture of at least one pixel; `brightness` below 1 dims it, so that what
  /// is drawn stands out. Throws codec::OutputError when Cairo cannot hold it.
  explicit PictureCanvas(const detect::ImageView& picture, double brightness = 1.0);

  void set_colour(const Colour& colour, double opacity = 1.0);
  /// Lines of `width_px` from point to point, closed at the end.
  void outline(const detect::Corners& corners, double width_px);
  void line(detect::Point from, detect::Point to, double width_px);
  void disc(detect::Point centre, double radius_px);
  /// Text of that height in the middle of `centre`, white on a dark plate.
  void label(detect::Point centre, double height_px, const std::string& text);

  /// What was drawn so far.
  io::RgbImage picture() const;

 private:
  struct DestroySurface {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };
  struct DestroyContext {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
  };

  std::unique_ptr<cairo_surface_t, DestroySurface> surface_;
  std::unique_ptr<cairo_t, DestroyContext> context_;
};

}  // namespace tagmint::draw
