#include "draw/ps_canvas.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "draw/numbers.h"
#include "draw/path_operators.h"
#include "draw/units.h"
#include "tagmint/codec/version.h"

namespace tagmint::draw {
namespace {

constexpr int kDigits = 5;               // of a mm
constexpr char32_t kFirstShared = 0x21;  // glyphs that the prolog holds: printable ASCII
constexpr char32_t kLastShared = 0x7e;

/// A string with its parentheses.
std::string ps_text(std::string_view utf8) {
  std::string out = "(";
  for (const char c : utf8) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0) == 0x80) continue;  // the rest of a character
    if (c == '(' || c == ')' || c == '\\') out += '\\';
    out += byte >= 0x20 && byte < 0x7f ? c : '?';
  }
  return out + ")";
}

std::string place_text(const Placement& place) {
  return fmt::format("{} {} {}", number_text(place.unit_mm, 8), number_text(place.x_mm, kDigits),
                     number_text(place.y_mm, kDigits));
}

/// "24 0 0 595 842": bounds in points, rounded outwards and exact.
std::string bounding_boxes(const PageSetup& page, std::string_view prefix) {
  const double width = kPointsAMm * page.width_mm;
  const double height = kPointsAMm * page.height_mm;
  return fmt::format("%%{0}BoundingBox: 0 0 {1:.0f} {2:.0f}\n", prefix, std::ceil(width - 1e-6),
                     std::ceil(height - 1e-6));
}

}  // namespace

PsCanvas::PsCanvas(ByteSink sink, Kind kind, std::string title, InkModel ink_model)
    : sink_(std::move(sink)), kind_(kind), title_(std::move(title)), ink_model_(ink_model) {}

void PsCanvas::put_header(const PageSetup& page) {
  text_ += kind_ == Kind::Eps ? "%!PS-Adobe-3.0 EPSF-3.0\n" : "%!PS-Adobe-3.0\n";
  text_ += fmt::format("%%Creator: tagmint {}\n%%Title: {}\n", codec::kVersion, ps_text(title_));
  text_ += "%%LanguageLevel: 2\n";
  if (kind_ == Kind::Eps) {
    text_ += bounding_boxes(page, "");
    text_ += fmt::format("%%HiResBoundingBox: 0 0 {} {}\n",
                         number_text(kPointsAMm * page.width_mm, kDigits),
                         number_text(kPointsAMm * page.height_mm, kDigits));
  }
  text_ += "%%Pages: (atend)\n%%EndComments\n%%BeginProlog\n/tagmint 200 dict def\ntagmint begin\n";
  // unit x y P: a new path there, in its own unit; F fills it, width S draws its lines.
  text_ +=
      "/m{moveto}bind def/l{lineto}bind def/c{curveto}bind def/h{closepath}bind def\n"
      "/P{gsave translate dup scale newpath}bind def\n"
      "/F{fill grestore}bind def\n/S{setlinewidth stroke grestore}bind def\n";
  text_ += ink_model_ == InkModel::Gray ? "/I{setgray}bind def\n"
                                        : "/I{1 exch sub 0 0 0 4 -1 roll setcmykcolor}bind def\n";
  for (char32_t c = kFirstShared; c <= kLastShared; ++c) {
    const Glyph& glyph = *typeface().glyphs(std::string(1, static_cast<char>(c)))[0];
    text_ += fmt::format("/g{:x}{{\n", static_cast<std::uint32_t>(c));
    append_path_operators(text_, glyph.outline, kDigits);
    text_ += "}bind def\n";
  }
  text_ += "end\n%%EndProlog\n";
}

void PsCanvas::put_if_large() {
  constexpr std::size_t kBlock = 1 << 16;
  if (text_.size() < kBlock) return;
  sink_(text_);
  text_.clear();
}

void PsCanvas::begin_page(const PageSetup& page) {
  if (kind_ == Kind::Eps && pages_ > 0) throw std::logic_error("an EPS file holds one page");
  if (pages_ == 0) put_header(page);
  ++pages_;
  const std::string width = number_text(kPointsAMm * page.width_mm, kDigits);
  const std::string height = number_text(kPointsAMm * page.height_mm, kDigits);
  text_ += fmt::format("%%Page: {} {}\n",
                       ps_text(page.label.empty() ? std::to_string(pages_) : page.label), pages_);
  text_ += bounding_boxes(page, "Page") + "%%BeginPageSetup\n";
  // Outside of what is restored at the page's end: that would end the page of this size.
  if (kind_ == Kind::Ps) text_ += fmt::format("<</PageSize[{} {}]>>setpagedevice\n", width, height);
  text_ += "/tagmintpage save def\n";
  // From here on the unit is the mm, and y runs down from the top.
  text_ += fmt::format("tagmint begin\n0 {} translate {} dup neg scale\n%%EndPageSetup\n", height,
                       number_text(kPointsAMm, 9));
}

void PsCanvas::paint_ground(const Path& area) { fill(area, {}, {.gray = 1.0}); }

void PsCanvas::fill(const Path& path, const Placement& place, const Ink& ink) {
  text_ += fmt::format("{} I {} P\n", number_text(ink.gray, 4), place_text(place));
  append_path_operators(text_, path, kDigits);
  text_ += "F\n";
  put_if_large();
}

void PsCanvas::stroke(const Path& path, const Placement& place, const Pen& pen) {
  text_ += fmt::format("{} I {} P\n", number_text(pen.ink.gray, 4), place_text(place));
  append_path_operators(text_, path, kDigits);
  text_ += fmt::format("{} S\n", number_text(pen.width_mm / place.unit_mm, kDigits));
  put_if_large();
}

void PsCanvas::show_text(const TextLine& line) {
  text_ += number_text(line.ink.gray, 4) + " I\n";
  double x = line.x_mm;
  for (const Glyph* glyph : line.glyphs) {
    const char32_t c = glyph->character;
    if (!glyph->outline.empty()) {
      text_ += place_text({x, line.baseline_mm, line.size_mm}) + " P ";
      if (c >= kFirstShared && c <= kLastShared) {
        text_ += fmt::format("g{:x} ", static_cast<std::uint32_t>(c));
      } else {
        append_path_operators(text_, glyph->outline, kDigits);
      }
      text_ += "F\n";
    }
    x += line.size_mm * glyph->advance;
  }
  put_if_large();
}

void PsCanvas::end_page() { text_ += "end tagmintpage restore showpage\n"; }

void PsCanvas::finish() {
  text_ += fmt::format("%%Trailer\n%%Pages: {}\n%%EOF\n", pages_);
  sink_(text_);
  text_.clear();
}

}  // namespace tagmint::draw
