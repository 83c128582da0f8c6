// PNG through libpng. The library reports faults by longjmp: each function that calls setjmp keeps
// its changing state in an object of its caller, so that nothing with a destructor is jumped over.
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "io/gray.h"
#include "io/image_codecs.h"
#include "io/images.h"
#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

using Message = char[160];

[[noreturn]] void on_error(png_structp png, png_const_charp text) {
  std::strncpy(static_cast<char*>(png_get_error_ptr(png)), text, sizeof(Message) - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

/// Owns libpng's structures for reading, and all that changes while they are in use.
struct PngReader {
  std::string_view bytes;
  const std::string& source;
  png_structp png = nullptr;
  png_infop info = nullptr;
  Message message = {};
  std::vector<png_byte> samples;  // one row, or all rows of an interlaced image
  std::vector<png_bytep> rows;
  detect::Image image;

  PngReader(std::string_view content, const std::string& name) : bytes(content), source(name) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, message, on_error, on_warning);
    if (png) info = png_create_info_struct(png);
    if (!info) {
      png_destroy_read_struct(&png, &info, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png, this, [](png_structp p, png_bytep out, std::size_t count) {
      auto& self = *static_cast<PngReader*>(png_get_io_ptr(p));
      if (self.bytes.size() < count) png_error(p, "it is cut short");
      std::memcpy(out, self.bytes.data(), count);
      self.bytes.remove_prefix(count);
    });
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
};

/// A row of 8 or 16 bit samples of 1 (gray), 2 (gray, alpha), 3 (colour) or 4 (colour, alpha)
/// channels as gray.
void row_to_gray(const png_byte* samples, int width, int channels, int bytes_a_sample,
                 std::uint8_t* gray) {
  const std::uint32_t top = bytes_a_sample == 1 ? 255 : 65535;
  const auto sample = [&](int x, int channel) -> std::uint32_t {
    const png_byte* at = samples + (std::size_t(x) * channels + channel) * bytes_a_sample;
    return bytes_a_sample == 1 ? at[0] : std::uint32_t{at[0]} << 8 | at[1];
  };
  for (int x = 0; x < width; ++x) {
    std::uint32_t value =
        channels < 3 ? sample(x, 0) : luma(sample(x, 0), sample(x, 1), sample(x, 2));
    if (channels % 2 == 0) value = over_white(value, sample(x, channels - 1), top);
    gray[x] = to_8_bits(value, top);
  }
}

/// Decodes into `self.image`. False when libpng found a fault, told in `self.message`.
bool read_pixels(PngReader& self) {
  if (setjmp(png_jmpbuf(self.png))) return false;
  png_set_user_limits(self.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_read_info(self.png, self.info);
  check_image_size(png_get_image_width(self.png, self.info),
                   png_get_image_height(self.png, self.info), self.source);
  png_set_expand(self.png);  // palettes, 1, 2 and 4 bits, transparent colours -> 8 bits and alpha
  const int passes = png_set_interlace_handling(self.png);
  png_read_update_info(self.png, self.info);

  const int channels = png_get_channels(self.png, self.info);
  const int bytes_a_sample = png_get_bit_depth(self.png, self.info) / 8;
  const std::size_t row_bytes = png_get_rowbytes(self.png, self.info);
  self.image.resize(static_cast<int>(png_get_image_width(self.png, self.info)),
                    static_cast<int>(png_get_image_height(self.png, self.info)));
  const int height = self.image.height();
  const int kept_rows = passes > 1 ? height : 1;
  self.samples.resize(row_bytes * kept_rows);
  for (int pass = 0; pass < passes; ++pass) {
    for (int y = 0; y < height; ++y) {
      png_bytep const row = self.samples.data() + row_bytes * (y % kept_rows);
      png_read_row(self.png, row, nullptr);
      if (pass == passes - 1) {
        row_to_gray(row, self.image.width(), channels, bytes_a_sample, self.image.row(y));
      }
    }
  }
  png_read_end(self.png, nullptr);
  return true;
}

/// Owns libpng's structures for writing.
struct PngWriter {
  std::string out;
  png_structp png = nullptr;
  png_infop info = nullptr;
  Message message = {};

  PngWriter() {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, message, on_error, on_warning);
    if (png) info = png_create_info_struct(png);
    if (!info) {
      png_destroy_write_struct(&png, &info);
      throw std::bad_alloc();
    }
    png_set_write_fn(png, this, append, [](png_structp) {});
  }
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  static void append(png_structp p, png_bytep data, std::size_t count) {
    bool done = true;
    try {
      static_cast<PngWriter*>(png_get_io_ptr(p))
          ->out.append(reinterpret_cast<const char*>(data), count);
    } catch (const std::exception&) {
      done = false;
    }
    if (!done) png_error(p, "out of memory");
  }
};

/// Rows of 8-bit samples that somebody else owns.
struct Pixels {
  const std::uint8_t* data;
  int width;
  int height;
  std::ptrdiff_t stride;
  int colour_type;  // PNG_COLOR_TYPE_GRAY or PNG_COLOR_TYPE_RGB
};

/// False when libpng found a fault, told in `self.message`.
bool write_pixels(PngWriter& self, const Pixels& pixels, png_uint_32 pixels_a_metre) {
  if (setjmp(png_jmpbuf(self.png))) return false;
  png_set_user_limits(self.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_IHDR(self.png, self.info, static_cast<png_uint_32>(pixels.width),
               static_cast<png_uint_32>(pixels.height), 8, pixels.colour_type, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (pixels_a_metre != 0) {
    png_set_pHYs(self.png, self.info, pixels_a_metre, pixels_a_metre, PNG_RESOLUTION_METER);
  }
  png_write_info(self.png, self.info);
  for (int y = 0; y < pixels.height; ++y) {
    png_write_row(self.png, pixels.data + y * pixels.stride);
  }
  png_write_end(self.png, nullptr);
  return true;
}

std::string encode(const Pixels& pixels, std::optional<double> dpi) {
  if (pixels.width < 1 || pixels.height < 1) {
    throw std::invalid_argument(
        fmt::format("an image of {} x {} pixels cannot be written; sides are 1 or more",
                    pixels.width, pixels.height));
  }
  constexpr double kMetresAnInch = 0.0254;
  if (dpi && !(*dpi > 0 && *dpi <= 1e6)) {
    throw std::invalid_argument(fmt::format("{} dpi cannot be; it is above 0 up to 1e6", *dpi));
  }
  const auto pixels_a_metre = static_cast<png_uint_32>(dpi ? std::lround(*dpi / kMetresAnInch) : 0);
  PngWriter writer;
  if (!write_pixels(writer, pixels, pixels_a_metre)) {
    throw codec::OutputError(fmt::format("the PNG image cannot be made: {}", writer.message), "",
                             "make the image smaller");
  }
  return std::move(writer.out);
}

}  // namespace

detect::Image decode_png(std::string_view bytes, const std::string& source) {
  PngReader reader(bytes, source);
  if (!read_pixels(reader)) throw_damaged("PNG", reader.message, source);
  return std::move(reader.image);
}

std::string encode_png(const detect::ImageView& image, std::optional<double> dpi) {
  return encode({image.data, image.width, image.height, image.stride, PNG_COLOR_TYPE_GRAY}, dpi);
}

std::string encode_png(const RgbImage& image, std::optional<double> dpi) {
  return encode({image.rgb.data(), image.width, image.height, std::ptrdiff_t{3} * image.width,
                 PNG_COLOR_TYPE_RGB},
                dpi);
}

}  // namespace tagmint::io
