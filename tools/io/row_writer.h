#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

namespace tagmint::io {

/// What the rows of a picture are, and how its file holds them.
struct RowFormat {
  int width = 0;             ///< pixels, > 0
  int height = 0;            ///< pixels, > 0
  int bits = 8;              ///< a pixel: 1 (below 128 is black) or 8
  bool transparent = false;  ///< white becomes transparent, gray partly so
  double dpi = 0.0;          ///< pixels per inch, noted in the file; > 0
};

/// Writes a picture row by row, so that it need not be in memory as a whole.
class RowWriter {
 public:
  virtual ~RowWriter() = default;
  /// The next row, from the top.
  ///   gray   RowFormat::width levels, 0 = black, 255 = white
  virtual void write(std::span<const std::uint8_t> gray) = 0;
  /// Completes the file after the last row.
  virtual void finish() = 0;
};

/// Takes the bytes of a file as they come.
using ByteSink = std::function<void(std::string_view)>;

/// A PNG file. Throws std::invalid_argument for a format that cannot be, codec::OutputError when
/// libpng fails; its members throw what the sink throws.
std::unique_ptr<RowWriter> png_row_writer(const RowFormat& format, ByteSink sink);

/// A TIFF file: 1 bit as CCITT group 4, which printing presses take, 8 bits with LZW. It is
/// compressed in memory and handed on at the end, since its header points there. Errors as
/// png_row_writer(), also for one bit with transparency, which TIFF does not have.
std::unique_ptr<RowWriter> tiff_row_writer(const RowFormat& format, ByteSink sink);

}  // namespace tagmint::io
