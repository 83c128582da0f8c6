#pragma once

#include <cairo.h>

#include <string>

#include "plot/style.h"

namespace tagmint::plot {

/// A box of the picture, px.
struct Box {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

enum class Align { Left, Middle, Right };

/// Few-word drawing with Cairo in the way of all figures: one typeface, sizes and tones.
class Pen {
 public:
  explicit Pen(cairo_t* context) : context_(context) {}

  /// Text with its baseline at y. `turned`: read from below, and y is where its middle is.
  void text(double x, double y, const std::string& text, double size_px, Align align,
            bool bold = false);
  void turned_text(double x, double y, const std::string& text, double size_px);
  double text_width(const std::string& text, double size_px, bool bold = false);

  /// A thin line of the axes and grids.
  void rule(double x0, double y0, double x1, double y1, double gray, double width_px);

  /// The current path in the style's line.
  void stroke(const Style& style);
  /// A marker about (x, y). `hollow`: its outline alone.
  void marker(const Style& style, double x, double y, bool hollow);
  /// An arrow downwards from (x, y): the value is at most that.
  void arrow_down(const Style& style, double x, double y);

  cairo_t* context() { return context_; }

 private:
  void use(const Style& style);
  void font(double size_px, bool bold);

  cairo_t* context_;
};

}  // namespace tagmint::plot
