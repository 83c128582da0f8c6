#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tagmint::test {

/// A PNG file of any colour type: what the readers' tests feed them.
struct PngParts {
  int width = 0;
  int height = 0;
  int bit_depth = 8;    ///< 1, 2, 4, 8, 16
  int colour_type = 0;  ///< PNG_COLOR_TYPE_...
  bool interlaced = false;
  std::vector<std::uint8_t> palette = {};        ///< red, green, blue each
  std::vector<std::uint8_t> palette_alpha = {};  ///< one an entry
  std::vector<std::vector<std::uint8_t>> rows =
      {};  ///< packed as PNG has them, 16 bits high byte first
};
std::string make_png(PngParts parts);

/// A JPEG file of quality 100, no chroma subsampling.
///   samples      width * height * components, row-major
///   components   1 = gray, 3 = RGB, 4 = CMYK as Adobe writes it (inverted)
std::string make_jpeg(int width, int height, int components, std::vector<std::uint8_t> samples,
                      bool progressive = false);

/// An uncompressed TIFF file of one strip.
struct TiffParts {
  int width = 0;
  int height = 0;
  int bits = 8;     ///< a sample
  int samples = 1;  ///< a pixel
  int photometric = 1;
  int extra_samples = -1;  ///< 1 = alpha already multiplied, 2 = alpha apart, -1 = none
  bool big_endian = false;
  std::vector<std::uint16_t> palette = {};  ///< all reds, all greens, all blues
  std::string pixels = {};                  ///< as in the file
};
std::string make_tiff(const TiffParts& parts);

}  // namespace tagmint::test
