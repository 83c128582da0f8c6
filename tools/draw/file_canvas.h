#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "draw/canvas.h"
#include "draw/colour_model.h"

namespace tagmint::draw {

/// Kinds of files that drawings are written as.
enum class FileKind { Pdf, Svg, Png, Tiff, Ps, Eps, Dxf };

/// Their names, as options and file extensions have them, in the order of FileKind.
std::span<const std::string_view> file_kind_names();
/// The kind of that name; nothing for another word. "tif" is a TIFF.
std::optional<FileKind> file_kind_of(std::string_view name);
std::string_view name_of(FileKind kind);

/// Whether a file of the kind may hold several pages: PDF and PostScript.
bool holds_pages(FileKind kind);
/// Whether it is made of pixels: PNG and TIFF.
bool is_raster(FileKind kind);

/// How a drawing becomes a file. What a kind does not know is not looked at.
struct FileOptions {
  std::string title;                    ///< noted in the file, UTF-8; may be empty
  InkModel ink_model = InkModel::Gray;  ///< PDF, PS, EPS
  std::optional<bool> white_ground;     ///< white, not transparent; see has_white_ground()
  double dpi = 300.0;                   ///< PNG, TIFF
  int bits = 8;                         ///< PNG, TIFF: 1 or 8
  bool outline = false;                 ///< hairlines around what would be filled
};

/// Whether the page is white where nothing is drawn: as the options say, else white in files made
/// for screens (SVG, PNG, TIFF) and free in those made for paper (PDF, PS, EPS, DXF). Raster files
/// see to that themselves; in the others Canvas::paint_ground() does it.
bool has_white_ground(FileKind kind, const FileOptions& options);

/// An empty drawing that becomes a file of that kind.
///   sink   takes the file's bytes, in order, as they are ready
std::unique_ptr<Canvas> make_canvas(FileKind kind, const FileOptions& options, ByteSink sink);

}  // namespace tagmint::draw
