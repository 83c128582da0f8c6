#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "draw/path.h"
#include "draw/typeface.h"

namespace tagmint::draw {

/// What a mark on the page is for. Kinds of files that know layers or groups keep them apart.
enum class Role { Tag, Label, Cut, Note };

/// A tone of black ink, and what is drawn with it.
struct Ink {
  double gray = 0.0;  ///< 0 = full ink, 1 = none
  Role role = Role::Tag;
};

/// How a line is drawn.
struct Pen {
  double width_mm = 0.1;  ///< > 0
  Ink ink;
};

/// An entry of a document's outline, which leads to its page.
struct Bookmark {
  std::string title;  ///< UTF-8
  int level = 0;      ///< 0 = topmost; at most one more than that of the entry before
};

/// A page about to be drawn.
struct PageSetup {
  double width_mm = 0.0;
  double height_mm = 0.0;
  std::string label;                ///< what viewers call the page; empty = its number
  std::vector<Bookmark> bookmarks;  ///< entries that lead to this page
};

/// One line of text, ready to be drawn.
struct TextLine {
  std::string text;                  ///< UTF-8
  std::vector<const Glyph*> glyphs;  ///< of the canvas's typeface, one a character
  double x_mm = 0.0;                 ///< where it starts
  double baseline_mm = 0.0;
  double size_mm = 0.0;  ///< of the font
  Ink ink;
};

/// Takes the bytes of a file as they come. Throws when they cannot be kept.
using ByteSink = std::function<void(std::string_view)>;

/// A drawing of one or more pages that becomes a file. Lengths are mm from the page's top-left
/// corner, x right, y down. Ink is only ever added: what is not drawn stays as the ground is. Pages
/// are begun and ended in turn; finish()
/// comes last. All members throw codec::OutputError where the
/// drawing cannot be made, and what their sink throws.
class Canvas {
 public:
  Canvas() = default;
  virtual ~Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  virtual void begin_page(const PageSetup& page) = 0;
  /// Makes white what the path covers (in mm), where the ground would be transparent; before
  /// anything else on the page.
  virtual void paint_ground(const Path& area) = 0;
  /// Fills the path; see Path.
  virtual void fill(const Path& path, const Placement& place, const Ink& ink) = 0;
  /// Draws the path's lines with their middle on it; butt ends, mitred corners.
  virtual void stroke(const Path& path, const Placement& place, const Pen& pen) = 0;
  /// Draws a line of text: the outlines of its glyphs, unless the kind of file knows fonts.
  virtual void show_text(const TextLine& line);
  virtual void end_page() = 0;
  /// Completes the file.
  virtual void finish() = 0;

  Typeface& typeface() { return typeface_; }

 private:
  Typeface typeface_;
};

}  // namespace tagmint::draw
