#include "draw/dxf_canvas.h"

#include <fmt/format.h>

#include <stdexcept>

#include "draw/numbers.h"

namespace tagmint::draw {
namespace {

constexpr int kDigits = 5;  // of a mm
constexpr double kToleranceMm = 0.005;

/// A layer's name and AutoCAD colour number: black (white on a dark screen), gray, red, gray.
struct Layer {
  Role role;
  const char* name;
  int colour;
};
constexpr Layer kLayers[] = {{Role::Tag, "TAGS", 7},
                             {Role::Label, "LABELS", 8},
                             {Role::Cut, "CUT", 1},
                             {Role::Note, "NOTES", 8}};

const char* layer_name(Role role) {
  for (const Layer& layer : kLayers) {
    if (layer.role == role) return layer.name;
  }
  return "0";
}

/// A group: its code and its value, a line each.
void append_group(std::string& out, int code, std::string_view value) {
  out += fmt::format("{}\n{}\n", code, value);
}

void append_point(std::string& out, const PathPoint& point) {
  append_group(out, 10, number_text(point.x, kDigits));
  append_group(out, 20, number_text(point.y, kDigits));
}

}  // namespace

DxfCanvas::DxfCanvas(ByteSink sink) : sink_(std::move(sink)) {}

void DxfCanvas::begin_page(const PageSetup& page) {
  if (has_page_) throw std::logic_error("a DXF file holds one page");
  has_page_ = true;
  height_mm_ = page.height_mm;
  constexpr const char* kMillimetres = "4";
  constexpr const char* kMetric = "1";
  text_ = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n";
  text_ += fmt::format("9\n$INSUNITS\n70\n{}\n9\n$MEASUREMENT\n70\n{}\n", kMillimetres, kMetric);
  text_ += "9\n$EXTMIN\n";
  append_point(text_, {0, 0});
  text_ += "9\n$EXTMAX\n";
  append_point(text_, {page.width_mm, page.height_mm});
  text_ += fmt::format("0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n{}\n",
                       std::size(kLayers));
  for (const Layer& layer : kLayers) {
    text_ +=
        fmt::format("0\nLAYER\n2\n{}\n70\n0\n62\n{}\n6\nCONTINUOUS\n", layer.name, layer.colour);
  }
  text_ += "0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
}

void DxfCanvas::put_if_large() {
  constexpr std::size_t kBlock = 1 << 16;
  if (text_.size() < kBlock) return;
  sink_(text_);
  text_.clear();
}

void DxfCanvas::add(const Path& path, const Placement& place, Role role) {
  const char* const layer = layer_name(role);
  for (const Polyline& line : flattened(path, kToleranceMm / place.unit_mm)) {
    text_ += fmt::format("0\nPOLYLINE\n8\n{}\n66\n1\n", layer);
    append_point(text_, {0, 0});
    append_group(text_, 70, line.closed ? "1" : "0");
    for (const PathPoint& point : line.points) {
      const PathPoint at = place.on_page(point);
      text_ += fmt::format("0\nVERTEX\n8\n{}\n", layer);
      append_point(text_, {at.x, height_mm_ - at.y});
    }
    text_ += fmt::format("0\nSEQEND\n8\n{}\n", layer);
  }
  put_if_large();
}

void DxfCanvas::paint_ground(const Path&) {}

void DxfCanvas::fill(const Path& path, const Placement& place, const Ink& ink) {
  add(path, place, ink.role);
}

void DxfCanvas::stroke(const Path& path, const Placement& place, const Pen& pen) {
  add(path, place, pen.ink.role);
}

void DxfCanvas::end_page() {}

void DxfCanvas::finish() {
  text_ += "0\nENDSEC\n0\nEOF\n";
  sink_(text_);
  text_.clear();
}

}  // namespace tagmint::draw
