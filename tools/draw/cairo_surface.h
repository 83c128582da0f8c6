#pragma once

#include <cairo.h>

#include <memory>
#include <optional>
#include <string>

namespace tagmint::draw {

struct DestroySurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyContext {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using SurfaceOwner = std::unique_ptr<cairo_surface_t, DestroySurface>;
using ContextOwner = std::unique_ptr<cairo_t, DestroyContext>;

/// A drawing of one or more pages that becomes the content of a file. The context's unit is the
/// millimetre, x right, y down, from the page's top-left corner.
class CairoCanvas {
 public:
  /// A PDF of any number of pages.
  ///   title   noted in the file, may be empty
  /// Throws codec::OutputError, as all members do, when Cairo fails.
  static CairoCanvas pdf(double width_mm, double height_mm, const std::string& title);
  /// An SVG of one page, its size given in mm. Nothing is painted below what is drawn.
  static CairoCanvas svg(double width_mm, double height_mm);
  /// A gray PNG of one white page; sides are rounded to whole pixels. Throws codec::OutputError
  /// when it has more pixels than Cairo or io::kMaxPixels allow.
  ///   dpi   pixels per inch, > 0
  static CairoCanvas png(double width_mm, double height_mm, double dpi);

  cairo_t* context() const { return context_.get(); }
  /// Ends the page; what follows goes to the next one.
  void finish_page();
  /// The content of the file; the canvas is used up. Throws std::invalid_argument when a text was
  /// not valid UTF-8.
  std::string finish();

 private:
  CairoCanvas(SurfaceOwner surface, std::unique_ptr<std::string> stream, double units_a_mm,
              std::optional<double> png_dpi);

  std::unique_ptr<std::string> stream_;  // what vector surfaces write to; its address is kept there
  SurfaceOwner surface_;
  ContextOwner context_;
  std::optional<double> png_dpi_;
};

}  // namespace tagmint::draw
