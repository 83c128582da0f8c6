#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "draw/file_canvas.h"
#include "tagmint/detect/image.h"

namespace tagmint::draw {

/// A page of a written file, drawn anew on white.
struct ReadPage {
  detect::Image picture;
  double pixels_a_mm = 0.0;
};

/// A written file, opened to be looked at.
class WrittenFile {
 public:
  virtual ~WrittenFile() = default;
  /// Draws a page at the size that the file gives it. Throws codec::OutputError where it cannot be
  /// drawn.
  ///   dpi   pixels per inch, > 0; a picture file has its own
  virtual ReadPage page(std::size_t index, double dpi) const = 0;
};

/// Whether this build can draw files of the kind: PDF with Poppler, SVG with librsvg, PNG and TIFF.
bool can_read_back(FileKind kind);

/// Opens a file of a kind that can be read back. Throws codec::OutputError where it cannot be read.
///   raster_dpi   pixels per inch of a picture file
std::unique_ptr<WrittenFile> open_written(const std::filesystem::path& path, FileKind kind,
                                          double raster_dpi);

}  // namespace tagmint::draw
