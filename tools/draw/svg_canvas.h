#pragma once

#include <optional>
#include <set>
#include <string>

#include "draw/canvas.h"

namespace tagmint::draw {

/// An SVG file of one page, its size and all its coordinates in mm, exact to 0.01 um. What belongs
/// together (tags, labels, cut lines, notes) is a group of that id. Browsers print it on a page of
/// its own size.
class SvgCanvas final : public Canvas {
 public:
  ///   title   UTF-8; may be empty
  SvgCanvas(ByteSink sink, std::string title);

  /// Throws std::logic_error for a second page.
  void begin_page(const PageSetup& page) override;
  void paint_ground(const Path& area) override;
  void fill(const Path& path, const Placement& place, const Ink& ink) override;
  void stroke(const Path& path, const Placement& place, const Pen& pen) override;
  void show_text(const TextLine& line) override;
  void end_page() override;
  void finish() override;

 private:
  void enter(std::optional<Role> role);
  void put_if_large();

  ByteSink sink_;
  std::string title_;
  std::string text_;  // not yet handed to the sink
  bool has_page_ = false;
  std::optional<Role> role_;  // of the open group
  std::set<Role> seen_;
  std::set<char32_t> defined_;  // glyphs that the file has
};

}  // namespace tagmint::draw
