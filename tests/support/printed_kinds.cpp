#include "support/printed_kinds.h"

#include "draw/sheet_writer.h"
#include "io/images.h"
#include "support/rasterise.h"

namespace tagmint::test {
namespace {

using draw::FileKind;
using draw::SheetDecor;
using draw::SheetPlan;

std::string content(const SheetPlan& plan, const SheetDecor& decor, FileKind kind) {
  return file_content(plan, decor, kind);
}

detect::Image own_picture(const SheetPlan& plan, const SheetDecor& decor, FileKind kind, int bits,
                          double dpi) {
  draw::FileOptions options;
  options.dpi = dpi;
  options.bits = bits;
  return io::decode_gray_image(file_content(plan, decor, kind, options), "sheet");
}

#ifdef TAGMINT_CHROMIUM
/// What Chromium prints of an SVG; it takes seconds, so the last one is kept.
const std::string& printed_svg(const std::string& svg) {
  static std::pair<std::string, std::string> last;
  if (last.first != svg) last = {svg, chromium_pdf(svg, TAGMINT_CHROMIUM)};
  return last.second;
}
#endif

}  // namespace

std::string file_content(const SheetPlan& plan, const SheetDecor& decor, FileKind kind,
                         const draw::FileOptions& options) {
  std::string bytes;
  draw::write_sheet(plan, decor, 0, 1, kind, options, [&](std::string_view b) { bytes += b; });
  return bytes;
}

std::vector<Printed> printed_kinds() {
  std::vector<Printed> kinds = {
      {"PDF, Poppler", false,
       [](const SheetPlan& plan, const SheetDecor& decor, double dpi) {
         return pdf_pages(content(plan, decor, FileKind::Pdf), dpi).at(0);
       }},
      {"SVG, librsvg", false,
       [](const SheetPlan& plan, const SheetDecor& decor, double dpi) {
         return svg_picture(content(plan, decor, FileKind::Svg), dpi);
       }},
      {"PNG", true,
       [](const SheetPlan& plan, const SheetDecor& decor, double dpi) {
         return own_picture(plan, decor, FileKind::Png, 8, dpi);
       }},
      {"TIFF of one bit", true,
       [](const SheetPlan& plan, const SheetDecor& decor, double dpi) {
         return own_picture(plan, decor, FileKind::Tiff, 1, dpi);
       }},
  };
#ifdef TAGMINT_HAVE_GHOSTSCRIPT
  const Printed with_ghostscript[] = {
      {"PDF, Ghostscript", false,
       [](const SheetPlan& plan, const SheetDecor& decor, double dpi) {
         return ghostscript_picture(content(plan, decor, FileKind::Pdf), dpi);
       }},
      {"PS, Ghostscript", false,
       [](const SheetPlan& plan, const SheetDecor& decor, double dpi) {
         return ghostscript_picture(content(plan, decor, FileKind::Ps), dpi);
       }},
      {"EPS, Ghostscript", false,
       [](const SheetPlan& plan, const SheetDecor& decor, double dpi) {
         return ghostscript_picture(content(plan, decor, FileKind::Eps), dpi);
       }},
  };
  kinds.insert(kinds.end(), std::begin(with_ghostscript), std::end(with_ghostscript));
#endif
#ifdef TAGMINT_CHROMIUM
  kinds.push_back({"SVG, Chromium, Poppler", false,
                   [](const SheetPlan& plan, const SheetDecor& decor, double dpi) {
                     return pdf_pages(printed_svg(content(plan, decor, FileKind::Svg)), dpi).at(0);
                   }});
#endif
  return kinds;
}

}  // namespace tagmint::test
