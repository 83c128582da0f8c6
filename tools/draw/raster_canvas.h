#pragma once

#include <cstdint>
#include <vector>

#include "draw/canvas.h"

namespace tagmint::draw {

/// A picture file of one page, PNG or TIFF, its resolution noted in it. The page is drawn and
/// written in bands, so that it need not be in memory as a whole. Edges between pixels get the gray
/// of their share; in a picture of one bit, pixels that are half covered or more are black,
/// whatever tone of ink was asked for.
class RasterCanvas final : public Canvas {
 public:
  enum class Kind { Png, Tiff };

  /// How the page becomes pixels.
  struct Options {
    double dpi = 300.0;        ///< pixels per inch, > 0
    int bits = 8;              ///< a pixel: 1 or 8
    bool transparent = false;  ///< what has no ink is transparent, else white
  };

  RasterCanvas(ByteSink sink, Kind kind, const Options& options);

  /// The sides are rounded to whole pixels. Throws codec::OutputError when there are too many of
  /// them, std::logic_error for a second page.
  void begin_page(const PageSetup& page) override;
  /// Nothing: the whole page has the ground of the options.
  void paint_ground(const Path& area) override;
  void fill(const Path& path, const Placement& place, const Ink& ink) override;
  void stroke(const Path& path, const Placement& place, const Pen& pen) override;
  /// Draws the page and hands it to the sink.
  void end_page() override;
  void finish() override;

 private:
  /// Something to be drawn, and the rows that it touches.
  struct Mark {
    Path path;
    Placement place;
    double pen_mm;  // 0 = filled
    double opacity;
    double top_px, bottom_px;
  };
  void add(const Path& path, const Placement& place, double pen_mm, double gray);

  ByteSink sink_;
  Kind kind_;
  Options options_;
  int width_ = 0;  // pixels; 0 = no page yet
  int height_ = 0;
  std::vector<Mark> marks_;
};

}  // namespace tagmint::draw
