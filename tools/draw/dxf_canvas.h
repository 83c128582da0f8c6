#pragma once

#include <string>

#include "draw/canvas.h"

namespace tagmint::draw {

/// A DXF file (release 12, the one that all programs read) of one page in mm: closed polylines
/// around all that would be filled, lines where lines are, on the layers TAGS, LABELS, CUT and
/// NOTES. Curves become straight pieces that leave them by at most 5 um. y runs up from the page's
/// lower edge, as DXF has it.
class DxfCanvas final : public Canvas {
 public:
  explicit DxfCanvas(ByteSink sink);

  /// Throws std::logic_error for a second page.
  void begin_page(const PageSetup& page) override;
  /// Nothing: there is no ground.
  void paint_ground(const Path& area) override;
  void fill(const Path& path, const Placement& place, const Ink& ink) override;
  /// The middle of the line; its width is not kept.
  void stroke(const Path& path, const Placement& place, const Pen& pen) override;
  void end_page() override;
  void finish() override;

 private:
  void add(const Path& path, const Placement& place, Role role);
  void put_if_large();

  ByteSink sink_;
  double height_mm_ = 0.0;
  bool has_page_ = false;
  std::string text_;  // not yet handed to the sink
};

}  // namespace tagmint::draw
