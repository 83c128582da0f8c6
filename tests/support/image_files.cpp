#include "support/image_files.h"

#include <cstdio>
// jpeglib.h needs FILE, so it follows <cstdio>.
#include <jpeglib.h>
#include <png.h>

#include <cstdlib>
#include <utility>

namespace tagmint::test {

std::string make_png(PngParts parts) {
  std::string out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &out,
      [](png_structp p, png_bytep data, std::size_t count) {
        static_cast<std::string*>(png_get_io_ptr(p))
            ->append(reinterpret_cast<const char*>(data), count);
      },
      [](png_structp) {});
  png_set_IHDR(png, info, static_cast<png_uint_32>(parts.width),
               static_cast<png_uint_32>(parts.height), parts.bit_depth, parts.colour_type,
               parts.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  std::vector<png_color> palette;
  for (std::size_t i = 0; i + 2 < parts.palette.size(); i += 3) {
    palette.push_back({parts.palette[i], parts.palette[i + 1], parts.palette[i + 2]});
  }
  if (!palette.empty()) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
  if (!parts.palette_alpha.empty()) {
    png_set_tRNS(png, info, parts.palette_alpha.data(),
                 static_cast<int>(parts.palette_alpha.size()), nullptr);
  }
  png_write_info(png, info);
  std::vector<png_bytep> rows;
  for (auto& row : parts.rows) rows.push_back(row.data());
  png_write_image(png, rows.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return out;
}

std::string make_jpeg(int width, int height, int components, std::vector<std::uint8_t> samples,
                      bool progressive) {
  jpeg_compress_struct jpeg = {};
  jpeg_error_mgr errors = {};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &buffer, &size);
  jpeg.image_width = static_cast<JDIMENSION>(width);
  jpeg.image_height = static_cast<JDIMENSION>(height);
  jpeg.input_components = components;
  jpeg.in_color_space = components == 1 ? JCS_GRAYSCALE : (components == 3 ? JCS_RGB : JCS_CMYK);
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 100, TRUE);
  jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor = 1;
  if (components == 4) jpeg.write_Adobe_marker = TRUE;
  if (progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  while (jpeg.next_scanline < jpeg.image_height) {
    JSAMPROW row = samples.data() + std::size_t{jpeg.next_scanline} * width * components;
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::string out(reinterpret_cast<const char*>(buffer), size);
  std::free(buffer);
  return out;
}

namespace {

/// Numbers in the byte order of a TIFF file.
class TiffWriter {
 public:
  explicit TiffWriter(bool big_endian) : big_endian_(big_endian) {}
  std::string number(std::uint32_t value, int bytes) const {
    std::string out;
    for (int i = 0; i < bytes; ++i) {
      const int shift = 8 * (big_endian_ ? bytes - 1 - i : i);
      out.push_back(static_cast<char>(value >> shift));
    }
    return out;
  }
  /// A directory entry of 16-bit numbers; more than two lie elsewhere, at `offset`.
  std::string entry(int tag, const std::vector<std::uint16_t>& values, std::uint32_t offset) const {
    std::string out = number(static_cast<std::uint32_t>(tag), 2) + number(3, 2) +
                      number(static_cast<std::uint32_t>(values.size()), 4);
    std::string inside;
    if (values.size() > 2) {
      inside = number(offset, 4);
    } else {
      for (const std::uint16_t value : values) inside += number(value, 2);
      inside.resize(4, '\0');
    }
    return out + inside;
  }

 private:
  bool big_endian_;
};

}  // namespace

std::string make_tiff(const TiffParts& parts) {
  const TiffWriter w(parts.big_endian);
  using Values = std::vector<std::uint16_t>;
  const Values bits(static_cast<std::size_t>(parts.samples),
                    static_cast<std::uint16_t>(parts.bits));
  constexpr std::uint32_t kHeader = 8;
  const auto bits_at = kHeader + static_cast<std::uint32_t>(parts.pixels.size());
  const auto palette_at = bits_at + static_cast<std::uint32_t>(2 * bits.size());
  const auto directory_at = palette_at + static_cast<std::uint32_t>(2 * parts.palette.size());

  std::vector<std::pair<int, Values>> fields = {
      {256, {static_cast<std::uint16_t>(parts.width)}},
      {257, {static_cast<std::uint16_t>(parts.height)}},
      {258, bits},
      {259, {1}},
      {262, {static_cast<std::uint16_t>(parts.photometric)}},
      {273, {kHeader}},
      {277, {static_cast<std::uint16_t>(parts.samples)}},
      {278, {static_cast<std::uint16_t>(parts.height)}},
      {279, {static_cast<std::uint16_t>(parts.pixels.size())}},
  };
  if (!parts.palette.empty()) fields.push_back({320, parts.palette});
  if (parts.extra_samples >= 0) {
    fields.push_back({338, {static_cast<std::uint16_t>(parts.extra_samples)}});
  }
  std::string out = (parts.big_endian ? "MM" : "II") + w.number(42, 2) + w.number(directory_at, 4);
  out += parts.pixels;
  for (const std::uint16_t value : bits) out += w.number(value, 2);
  for (const std::uint16_t value : parts.palette) out += w.number(value, 2);
  out += w.number(static_cast<std::uint32_t>(fields.size()), 2);
  for (const auto& [tag, values] : fields) {
    out += w.entry(tag, values, tag == 320 ? palette_at : bits_at);
  }
  return out + w.number(0, 4);
}

}  // namespace tagmint::test
