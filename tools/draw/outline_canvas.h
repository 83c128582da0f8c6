#pragma once

#include <memory>

#include "draw/canvas.h"

namespace tagmint::draw {

/// Draws on another canvas, but of all that would be filled only the outline, as a hairline: what
/// laser cutters and engravers follow. No ground is painted, and text becomes outlines.
class OutlineCanvas final : public Canvas {
 public:
  explicit OutlineCanvas(std::unique_ptr<Canvas> canvas);

  void begin_page(const PageSetup& page) override;
  void paint_ground(const Path& area) override;
  void fill(const Path& path, const Placement& place, const Ink& ink) override;
  void stroke(const Path& path, const Placement& place, const Pen& pen) override;
  void end_page() override;
  void finish() override;

 private:
  std::unique_ptr<Canvas> canvas_;
};

}  // namespace tagmint::draw
