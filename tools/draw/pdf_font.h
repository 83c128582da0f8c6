#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "draw/pdf_file.h"
#include "draw/typeface.h"

namespace tagmint::draw {

/// A place in PdfFonts: the glyph `code` of the font `font`.
struct GlyphCode {
  std::size_t font = 0;
  int code = 0;
};

/// The glyphs that a PDF uses, as fonts of their outlines (Type 3) in which text can be searched:
/// the file needs no font of the reader's system.
///   source   ISO 32000-1:2008, 9.6.5 (Type 3 fonts), 9.10.3 (ToUnicode)
class PdfFonts {
 public:
  /// The glyph's place; the same one each time.
  GlyphCode code_of(const Glyph& glyph);
  /// Writes all fonts; returns the entries of the resource dictionary /Font: "/F0 7 0 R ...".
  std::string write(PdfFile& file) const;

 private:
  static constexpr std::size_t kGlyphsAFont = 256;

  std::vector<const Glyph*> glyphs_;  // in the order of their codes, font after font
  std::map<char32_t, GlyphCode> codes_;
};

}  // namespace tagmint::draw
