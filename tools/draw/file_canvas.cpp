#include "draw/file_canvas.h"

#include <algorithm>
#include <array>

#include "draw/dxf_canvas.h"
#include "draw/outline_canvas.h"
#include "draw/pdf_canvas.h"
#include "draw/ps_canvas.h"
#include "draw/raster_canvas.h"
#include "draw/svg_canvas.h"

namespace tagmint::draw {
namespace {

constexpr std::array<std::string_view, 7> kNames = {"pdf", "svg", "png", "tiff",
                                                    "ps",  "eps", "dxf"};

std::unique_ptr<Canvas> plain_canvas(FileKind kind, const FileOptions& options, ByteSink sink) {
  const RasterCanvas::Options raster{
      .dpi = options.dpi, .bits = options.bits, .transparent = !has_white_ground(kind, options)};
  switch (kind) {
    case FileKind::Pdf:
      return std::make_unique<PdfCanvas>(std::move(sink), options.title, options.ink_model);
    case FileKind::Svg:
      return std::make_unique<SvgCanvas>(std::move(sink), options.title);
    case FileKind::Png:
      return std::make_unique<RasterCanvas>(std::move(sink), RasterCanvas::Kind::Png, raster);
    case FileKind::Tiff:
      return std::make_unique<RasterCanvas>(std::move(sink), RasterCanvas::Kind::Tiff, raster);
    case FileKind::Ps:
      return std::make_unique<PsCanvas>(std::move(sink), PsCanvas::Kind::Ps, options.title,
                                        options.ink_model);
    case FileKind::Eps:
      return std::make_unique<PsCanvas>(std::move(sink), PsCanvas::Kind::Eps, options.title,
                                        options.ink_model);
    case FileKind::Dxf:
      return std::make_unique<DxfCanvas>(std::move(sink));
  }
  return nullptr;
}

}  // namespace

std::span<const std::string_view> file_kind_names() { return kNames; }

std::optional<FileKind> file_kind_of(std::string_view name) {
  if (name == "tif") name = "tiff";
  const auto* const place = std::find(kNames.begin(), kNames.end(), name);
  if (place == kNames.end()) return std::nullopt;
  return static_cast<FileKind>(place - kNames.begin());
}

std::string_view name_of(FileKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

bool holds_pages(FileKind kind) { return kind == FileKind::Pdf || kind == FileKind::Ps; }

bool is_raster(FileKind kind) { return kind == FileKind::Png || kind == FileKind::Tiff; }

bool has_white_ground(FileKind kind, const FileOptions& options) {
  return options.white_ground.value_or(kind == FileKind::Svg || is_raster(kind));
}

std::unique_ptr<Canvas> make_canvas(FileKind kind, const FileOptions& options, ByteSink sink) {
  std::unique_ptr<Canvas> canvas = plain_canvas(kind, options, std::move(sink));
  // A DXF file is outlines in any case.
  if (!options.outline || kind == FileKind::Dxf) return canvas;
  return std::make_unique<OutlineCanvas>(std::move(canvas));
}

}  // namespace tagmint::draw
