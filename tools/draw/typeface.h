#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "draw/path.h"

namespace tagmint::draw {

/// The picture of one character; lengths in units of the font's size.
struct Glyph {
  char32_t character = 0;
  Path outline;          ///< its origin on the baseline, y down
  double advance = 0.0;  ///< to the origin of the next glyph
};

/// The system's sans-serif font as outlines, the same for every kind of file. Glyphs stay where
/// they are as long as the typeface lives. For one thread.
class Typeface {
 public:
  Typeface();
  ~Typeface();
  Typeface(const Typeface&) = delete;
  Typeface& operator=(const Typeface&) = delete;

  /// The glyphs of a text, one a character. Throws std::invalid_argument when it is not UTF-8.
  std::vector<const Glyph*> glyphs(const std::string& text);

 private:
  struct Font;
  Glyph load(char32_t character) const;

  std::unique_ptr<Font> font_;
  std::map<char32_t, Glyph> glyphs_;
};

/// Width of a line for font size 1.
double width_of(const std::vector<const Glyph*>& glyphs);

}  // namespace tagmint::draw
