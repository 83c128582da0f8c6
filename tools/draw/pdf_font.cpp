#include "draw/pdf_font.h"

#include <fmt/format.h>

#include <span>

#include "draw/numbers.h"
#include "draw/path_operators.h"
#include "draw/utf8.h"

namespace tagmint::draw {
namespace {

/// Units of glyph space in the size of the font.
constexpr double kUnits = 1000.0;

Path scaled(const Path& path, double factor) {
  Path out;
  for_each_step(path, [&](Path::Step step, const PathPoint* p) {
    switch (step) {
      case Path::Step::Move:
        return out.move_to(factor * p[0].x, factor * p[0].y);
      case Path::Step::Line:
        return out.line_to(factor * p[0].x, factor * p[0].y);
      case Path::Step::Curve:
        return out.curve_to(factor * p[0].x, factor * p[0].y, factor * p[1].x, factor * p[1].y,
                            factor * p[2].x, factor * p[2].y);
      case Path::Step::Close:
        return out.close();
    }
  });
  return out;
}

/// The drawing of one glyph: width, bounds, outline. Glyph space has y up.
std::string glyph_program(const Glyph& glyph) {
  const PathBounds box = bounds(glyph.outline);
  std::string program =
      fmt::format("{} 0 {} {} {} {} d1\n", number_text(kUnits * glyph.advance, 3),
                  number_text(kUnits * box.left - 1, 0), number_text(-kUnits * box.bottom - 1, 0),
                  number_text(kUnits * box.right + 1, 0), number_text(-kUnits * box.top + 1, 0));
  if (glyph.outline.empty()) return program;
  program += "1 0 0 -1 0 0 cm\n";
  append_path_operators(program, scaled(glyph.outline, kUnits), 2);
  return program + "f\n";
}

/// Which characters the codes stand for, so that text can be searched and copied.
std::string unicode_map(std::span<const Glyph* const> glyphs) {
  std::string map =
      "/CIDInit/ProcSet findresource begin\n12 dict begin\nbegincmap\n"
      "/CMapName/tagmint def\n/CMapType 2 def\n"
      "1 begincodespacerange\n<00><FF>\nendcodespacerange\n";
  constexpr std::size_t kLinesABlock = 100;  // as the format allows
  for (std::size_t start = 0; start < glyphs.size(); start += kLinesABlock) {
    const auto block = glyphs.subspan(start, std::min(kLinesABlock, glyphs.size() - start));
    map += fmt::format("{} beginbfchar\n", block.size());
    for (std::size_t i = 0; i < block.size(); ++i) {
      std::string unicode = pdf_text(utf8_of(block[i]->character));
      unicode.erase(1, 4);  // the byte order mark has no place here
      map += fmt::format("<{:02X}>{}\n", start + i, unicode);
    }
    map += "endbfchar\n";
  }
  return map + "endcmap\nCMapName currentdict/CMap defineresource pop\nend\nend\n";
}

std::string write_font(PdfFile& file, std::span<const Glyph* const> glyphs) {
  std::string names, programs, widths;
  PathBounds all;
  for (std::size_t code = 0; code < glyphs.size(); ++code) {
    const Glyph& glyph = *glyphs[code];
    names += fmt::format("/g{}", code);
    programs +=
        fmt::format("/g{} {}", code, pdf_reference(file.add_stream("", glyph_program(glyph))));
    widths += number_text(kUnits * glyph.advance, 3) + " ";
    const PathBounds box = bounds(glyph.outline);
    all = {std::min(all.left, box.left), std::min(all.top, box.top), std::max(all.right, box.right),
           std::max(all.bottom, box.bottom)};
  }
  const int unicode = file.add_stream("", unicode_map(glyphs));
  return pdf_reference(file.add(
      fmt::format("<</Type/Font/Subtype/Type3/FontBBox[{} {} {} {}]/FontMatrix[0.001 0 0 0.001 0 0]"
                  "/CharProcs<<{}>>/Encoding<</Type/Encoding/Differences[0{}]>>"
                  "/FirstChar 0/LastChar {}/Widths[{}]/Resources<<>>/ToUnicode {}>>",
                  number_text(kUnits * all.left - 1, 0), number_text(-kUnits * all.bottom - 1, 0),
                  number_text(kUnits * all.right + 1, 0), number_text(-kUnits * all.top + 1, 0),
                  programs, names, glyphs.size() - 1, widths, pdf_reference(unicode))));
}

}  // namespace

GlyphCode PdfFonts::code_of(const Glyph& glyph) {
  const auto [place, is_new] = codes_.try_emplace(glyph.character);
  if (is_new) {
    place->second = {glyphs_.size() / kGlyphsAFont,
                     static_cast<int>(glyphs_.size() % kGlyphsAFont)};
    glyphs_.push_back(&glyph);
  }
  return place->second;
}

std::string PdfFonts::write(PdfFile& file) const {
  std::string entries;
  const std::span<const Glyph* const> all = glyphs_;
  for (std::size_t start = 0; start < all.size(); start += kGlyphsAFont) {
    const auto glyphs = all.subspan(start, std::min(kGlyphsAFont, all.size() - start));
    entries += fmt::format("/F{} {}", start / kGlyphsAFont, write_font(file, glyphs));
  }
  return entries;
}

}  // namespace tagmint::draw
