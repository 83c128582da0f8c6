#include "draw/svg_canvas.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "draw/numbers.h"
#include "draw/utf8.h"

namespace tagmint::draw {
namespace {

constexpr int kDigits = 5;            // of a mm
constexpr double kGlyphUnits = 1000;  // of the font's size

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string colour(double gray) {
  const int level = static_cast<int>(std::lround(255 * gray));
  return fmt::format("#{0:02x}{0:02x}{0:02x}", level);
}

const char* group_name(Role role) {
  switch (role) {
    case Role::Tag:
      return "tags";
    case Role::Label:
      return "labels";
    case Role::Cut:
      return "cut";
    case Role::Note:
      return "notes";
  }
  return "";
}

/// The value of a path's attribute d, placed on the page. Lines along the axes are H and V.
void append_path(std::string& out, const Path& path, const Placement& place) {
  const auto put = [&](const PathPoint& point) {
    append_number(out, point.x, kDigits);
    out += ' ';
    append_number(out, point.y, kDigits);
  };
  PathPoint last;
  for_each_step(path, [&](Path::Step step, const PathPoint* points) {
    switch (step) {
      case Path::Step::Move:
        last = place.on_page(points[0]);
        out += 'M';
        put(last);
        return;
      case Path::Step::Line: {
        const PathPoint point = place.on_page(points[0]);
        if (point.y == last.y) {
          out += 'H';
          append_number(out, point.x, kDigits);
        } else if (point.x == last.x) {
          out += 'V';
          append_number(out, point.y, kDigits);
        } else {
          out += 'L';
          put(point);
        }
        last = point;
        return;
      }
      case Path::Step::Curve:
        for (int i = 0; i < 3; ++i) {
          out += i == 0 ? 'C' : ' ';
          put(place.on_page(points[i]));
        }
        last = place.on_page(points[2]);
        return;
      case Path::Step::Close:
        out += 'Z';
        return;
    }
  });
}

}  // namespace

SvgCanvas::SvgCanvas(ByteSink sink, std::string title)
    : sink_(std::move(sink)), title_(std::move(title)) {
  characters_of(title_);  // throws where it is not UTF-8
}

void SvgCanvas::begin_page(const PageSetup& page) {
  if (has_page_) throw std::logic_error("an SVG file holds one page");
  has_page_ = true;
  const std::string width = number_text(page.width_mm, kDigits);
  const std::string height = number_text(page.height_mm, kDigits);
  text_ += fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "version=\"1.1\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n",
      width, height);
  if (!title_.empty()) text_ += fmt::format("<title>{}</title>\n", escaped(title_));
  text_ += fmt::format("<style>@page{{size:{}mm {}mm;margin:0}}</style>\n", width, height);
}

/// Ends the open group and begins that of the role, where it is another one.
void SvgCanvas::enter(std::optional<Role> role) {
  if (role == role_) return;
  if (role_) text_ += "</g>\n";
  role_ = role;
  if (!role) return;
  // An id comes once in a file; a group that is entered again has none.
  text_ += seen_.insert(*role).second ? fmt::format("<g id=\"{}\">\n", group_name(*role)) : "<g>\n";
}

void SvgCanvas::put_if_large() {
  constexpr std::size_t kBlock = 1 << 16;
  if (text_.size() < kBlock) return;
  sink_(text_);
  text_.clear();
}

void SvgCanvas::paint_ground(const Path& area) {
  enter({});
  text_ += "<path id=\"ground\" fill=\"#ffffff\" d=\"";
  append_path(text_, area, {});
  text_ += "\"/>\n";
}

void SvgCanvas::fill(const Path& path, const Placement& place, const Ink& ink) {
  enter(ink.role);
  text_ += fmt::format("<path fill=\"{}\" d=\"", colour(ink.gray));
  append_path(text_, path, place);
  text_ += "\"/>\n";
  put_if_large();
}

void SvgCanvas::stroke(const Path& path, const Placement& place, const Pen& pen) {
  enter(pen.ink.role);
  text_ += fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" d=\"",
                       colour(pen.ink.gray), number_text(pen.width_mm, kDigits));
  append_path(text_, path, place);
  text_ += "\"/>\n";
  put_if_large();
}

void SvgCanvas::show_text(const TextLine& line) {
  enter(line.ink.role);
  for (const Glyph* glyph : line.glyphs) {
    if (glyph->outline.empty() || !defined_.insert(glyph->character).second) continue;
    text_ +=
        fmt::format("<defs><path id=\"g{:x}\" d=\"", static_cast<std::uint32_t>(glyph->character));
    append_path(text_, glyph->outline, {0, 0, kGlyphUnits});
    text_ += "\"/></defs>\n";
  }
  text_ += fmt::format("<g aria-label=\"{}\" fill=\"{}\" transform=\"translate({} {}) scale({})\">",
                       escaped(line.text), colour(line.ink.gray), number_text(line.x_mm, kDigits),
                       number_text(line.baseline_mm, kDigits),
                       number_text(line.size_mm / kGlyphUnits, 9));
  double x = 0.0;
  for (const Glyph* glyph : line.glyphs) {
    if (!glyph->outline.empty()) {
      text_ += fmt::format("<use xlink:href=\"#g{:x}\" x=\"{}\"/>",
                           static_cast<std::uint32_t>(glyph->character), number_text(x, 2));
    }
    x += kGlyphUnits * glyph->advance;
  }
  text_ += "</g>\n";
  put_if_large();
}

void SvgCanvas::end_page() { enter({}); }

void SvgCanvas::finish() {
  text_ += "</svg>\n";
  sink_(text_);
  text_.clear();
}

}  // namespace tagmint::draw
