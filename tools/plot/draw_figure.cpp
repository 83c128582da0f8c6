#include "plot/draw_figure.h"

#include <cairo-svg.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "draw/cairo_owners.h"
#include "plot/legend.h"
#include "plot/panel.h"
#include "plot/pen.h"

namespace tagmint::plot {
namespace {

constexpr double kPanelWidth_px = 400;
constexpr double kPanelHeight_px = 290;
constexpr double kTallPanelHeight_px = 340;  // with names below its axis
constexpr double kMargin_px = 10;
constexpr double kTitleHeight_px = 30;
constexpr double kTitle_px = 15;
constexpr double kNoteHeight_px = 15;
constexpr double kNote_px = 10;

struct Size {
  double width = 0;
  double height = 0;
  double panel_height = 0;
  int columns = 1;
};

/// The note in lines that fit, broken behind semicolons where it can be.
std::vector<std::string> note_lines(Pen& pen, const std::string& note, double width_px) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < note.size();) {
    const std::size_t semicolon = note.find("; ", begin);
    const std::size_t end = semicolon == std::string::npos ? note.size() : semicolon + 2;
    const std::string part = note.substr(begin, end - begin);
    if (!lines.empty() && pen.text_width(lines.back() + part, kNote_px) <= width_px) {
      lines.back() += part;
    } else {
      lines.push_back(part);
    }
    begin = end;
  }
  return lines;
}

Size size_of(const Figure& figure) {
  if (figure.panels.empty()) throw std::invalid_argument("a figure has at least one panel");
  const int panels = static_cast<int>(figure.panels.size());
  Size size;
  size.columns = std::clamp(figure.columns, 1, panels);
  const int rows = (panels + size.columns - 1) / size.columns;
  const bool named = std::any_of(figure.panels.begin(), figure.panels.end(),
                                 [](const Panel& panel) { return panel.x.categories.size() > 4; });
  size.panel_height = named ? kTallPanelHeight_px : kPanelHeight_px;
  // A figure of one panel is wider than one of many.
  const double width = size.columns == 1 ? 1.6 * kPanelWidth_px : size.columns * kPanelWidth_px;
  size.width = width + 2 * kMargin_px;
  size.height = kTitleHeight_px + rows * size.panel_height + kMargin_px;
  const draw::SurfaceOwner surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const draw::ContextOwner context(cairo_create(surface.get()));
  Pen pen(context.get());
  const double inner = size.width - 2 * kMargin_px;
  size.height += kLegendRow_px * legend_rows(pen, legend_of(figure), inner) +
                 kNoteHeight_px * static_cast<double>(note_lines(pen, figure.note, inner).size());
  return size;
}

void draw(cairo_t* context, const Figure& figure, const Size& size) {
  Pen pen(context);
  cairo_set_source_rgb(context, 1, 1, 1);
  cairo_paint(context);
  pen.text(size.width / 2, kTitleHeight_px - 10, figure.title, kTitle_px, Align::Middle, true);
  const double width = (size.width - 2 * kMargin_px) / size.columns;
  double bottom = kTitleHeight_px;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const auto column = static_cast<double>(i % static_cast<std::size_t>(size.columns));
    const auto row = static_cast<double>(i / static_cast<std::size_t>(size.columns));
    const Box box{kMargin_px + column * width, kTitleHeight_px + row * size.panel_height, width,
                  size.panel_height};
    draw_panel(pen, figure.panels[i], box);
    bottom = box.bottom();
  }
  draw_legend(pen, legend_of(figure), {kMargin_px, bottom, size.width - 2 * kMargin_px, 0});
  const auto lines = note_lines(pen, figure.note, size.width - 2 * kMargin_px);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto below = static_cast<double>(lines.size() - 1 - i);
    pen.text(kMargin_px, size.height - 8 - below * kNoteHeight_px, lines[i], kNote_px, Align::Left);
  }
  draw::check_cairo(cairo_status(context));
}

cairo_status_t append(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

/// Cairo numbers surfaces over the life of a process; in the file the number says nothing.
void remove_surface_number(std::string& svg) {
  const std::string id = "id=\"surface";
  const std::size_t at = svg.find(id);
  if (at == std::string::npos) return;
  const std::size_t digits = at + id.size();
  const std::size_t end = svg.find('"', digits);
  svg.erase(digits, end - digits);
}

}  // namespace

std::string describe(const Figure& figure) {
  std::string text;
  for (const Panel& panel : figure.panels) {
    std::string labels;
    for (const Series& series : panel.series) {
      if (series.label.empty()) continue;
      labels += fmt::format("{}{}", labels.empty() ? ": " : "; ", series.label);
    }
    text += fmt::format("{}{}{}{} against {}{}.", text.empty() ? "" : " ", panel.title,
                        panel.title.empty() ? "" : ": ", panel.y.label, panel.x.label, labels);
  }
  return text;
}

std::string figure_svg(const Figure& figure) {
  const Size size = size_of(figure);
  std::string svg;
  {
    const draw::SurfaceOwner surface(
        cairo_svg_surface_create_for_stream(append, &svg, size.width, size.height));
    draw::check_cairo(cairo_surface_status(surface.get()));
    cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
    {
      const draw::ContextOwner context(cairo_create(surface.get()));
      draw(context.get(), figure, size);
    }
    cairo_surface_finish(surface.get());
    draw::check_cairo(cairo_surface_status(surface.get()));
  }
  remove_surface_number(svg);
  const std::size_t root = svg.find('>', svg.find("<svg"));
  svg.insert(root + 1, fmt::format("\n<title>{}</title>\n<desc>{}</desc>", escaped(figure.title),
                                   escaped(describe(figure))));
  return svg;
}

std::string figure_png(const Figure& figure, double scale) {
  const Size size = size_of(figure);
  const draw::SurfaceOwner surface(cairo_image_surface_create(
      CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(scale * size.width)),
      static_cast<int>(std::lround(scale * size.height))));
  draw::check_cairo(cairo_surface_status(surface.get()));
  const draw::ContextOwner context(cairo_create(surface.get()));
  cairo_scale(context.get(), scale, scale);
  draw(context.get(), figure, size);
  std::string png;
  draw::check_cairo(cairo_surface_write_to_png_stream(surface.get(), append, &png));
  return png;
}

}  // namespace tagmint::plot
