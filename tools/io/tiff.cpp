// TIFF through libtiff, from memory, with its messages caught per file.
#include <tiffio.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "io/gray.h"
#include "io/image_codecs.h"
#include "io/images.h"
#include "io/tiff_messages.h"
#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

/// The bytes of a TIFF file, read as libtiff asks, and its first complaint.
struct TiffSource : TiffMessages {
  std::string_view bytes;
  std::uint64_t at = 0;
};

tmsize_t read_bytes(thandle_t handle, void* out, tmsize_t count) {
  auto& self = *static_cast<TiffSource*>(handle);
  if (self.at >= self.bytes.size() || count <= 0) return 0;
  const auto taken =
      std::min<std::uint64_t>(static_cast<std::uint64_t>(count), self.bytes.size() - self.at);
  std::memcpy(out, self.bytes.data() + self.at, taken);
  self.at += taken;
  return static_cast<tmsize_t>(taken);
}

toff_t seek(thandle_t handle, toff_t offset, int whence) {
  auto& self = *static_cast<TiffSource*>(handle);
  const std::uint64_t base =
      whence == SEEK_CUR ? self.at : (whence == SEEK_END ? self.bytes.size() : 0);
  return self.at = base + offset;
}

using Tiff = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

Tiff open(TiffSource& content) {
  const auto options = content.open_options();
  // No single table or strip of an image that is read is larger than all its pixels as RGBA.
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), tmsize_t{4} * kMaxPixels);
  return Tiff(
      TIFFClientOpenExt(
          "", "rm", &content, read_bytes, [](thandle_t, void*, tmsize_t) -> tmsize_t { return 0; },
          seek, [](thandle_t) { return 0; },
          [](thandle_t handle) -> toff_t { return static_cast<TiffSource*>(handle)->bytes.size(); },
          nullptr, nullptr, options.get()),
      &TIFFClose);
}

std::uint16_t field(TIFF* tiff, std::uint32_t tag) {
  std::uint16_t value = 0;
  TIFFGetFieldDefaulted(tiff, tag, &value);
  return value;
}

/// Whether the file is rows of 16-bit gray: those are read with all their bits, since libtiff's
/// RGBA reader drops the low ones unrounded.
bool is_gray_16(TIFF* tiff) {
  const std::uint16_t photometric = field(tiff, TIFFTAG_PHOTOMETRIC);
  return field(tiff, TIFFTAG_BITSPERSAMPLE) == 16 && field(tiff, TIFFTAG_SAMPLESPERPIXEL) == 1 &&
         field(tiff, TIFFTAG_SAMPLEFORMAT) == SAMPLEFORMAT_UINT && !TIFFIsTiled(tiff) &&
         field(tiff, TIFFTAG_ORIENTATION) == ORIENTATION_TOPLEFT &&
         (photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE);
}

bool read_gray_16(TIFF* tiff, detect::Image& image) {
  const std::uint32_t flip = field(tiff, TIFFTAG_PHOTOMETRIC) == PHOTOMETRIC_MINISWHITE ? 65535 : 0;
  std::vector<std::uint16_t> samples(static_cast<std::size_t>(image.width()));
  if (TIFFScanlineSize64(tiff) != samples.size() * sizeof(samples[0])) return false;
  for (int y = 0; y < image.height(); ++y) {
    if (TIFFReadScanline(tiff, samples.data(), static_cast<std::uint32_t>(y), 0) != 1) return false;
    std::uint8_t* const row = image.row(y);
    for (int x = 0; x < image.width(); ++x) row[x] = to_8_bits(samples[x] ^ flip, 65535);
  }
  return true;
}

/// Any kind that libtiff knows, through its RGBA reader: colours multiplied by alpha.
bool read_rgba(TIFF* tiff, detect::Image& image, TiffSource& content) {
  char reason[1024] = {};
  const auto complain = [&] {
    if (content.message[0] == '\0') {
      std::snprintf(content.message, sizeof(content.message), "%.190s", reason);
    }
    return false;
  };
  TIFFRGBAImage reader;
  constexpr int kStopOnError = 1;
  if (!TIFFRGBAImageOK(tiff, reason) || !TIFFRGBAImageBegin(&reader, tiff, kStopOnError, reason)) {
    return complain();
  }
  const std::unique_ptr<TIFFRGBAImage, decltype(&TIFFRGBAImageEnd)> owner(&reader,
                                                                          &TIFFRGBAImageEnd);
  reader.req_orientation = ORIENTATION_TOPLEFT;
  std::vector<std::uint32_t> raster(std::size_t(image.width()) * image.height());
  if (!TIFFRGBAImageGet(&reader, raster.data(), static_cast<std::uint32_t>(image.width()),
                        static_cast<std::uint32_t>(image.height()))) {
    return complain();
  }
  const std::uint32_t* pixel = raster.data();
  for (int y = 0; y < image.height(); ++y) {
    std::uint8_t* const row = image.row(y);
    for (int x = 0; x < image.width(); ++x, ++pixel) {
      const std::uint32_t value =
          luma(TIFFGetR(*pixel), TIFFGetG(*pixel), TIFFGetB(*pixel)) + 255 - TIFFGetA(*pixel);
      row[x] = static_cast<std::uint8_t>(std::min(value, std::uint32_t{255}));
    }
  }
  return true;
}

}  // namespace

detect::Image decode_tiff(std::string_view bytes, const std::string& source) {
  TiffSource content;
  content.bytes = bytes;
  const Tiff tiff = open(content);
  const auto fail = [&]() -> void {
    throw_damaged("TIFF", content.message[0] ? content.message : "it is cut short", source);
  };
  if (!tiff) fail();
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  if (!TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width) ||
      !TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height)) {
    throw_damaged("TIFF", "it has no width and height", source);
  }
  check_image_size(width, height, source);
  detect::Image image(static_cast<int>(width), static_cast<int>(height));
  const bool done = is_gray_16(tiff.get()) ? read_gray_16(tiff.get(), image)
                                           : read_rgba(tiff.get(), image, content);
  if (!done) fail();
  return image;
}

}  // namespace tagmint::io
