// TIFF row by row through libtiff, into memory, with its messages caught per file.
#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

#include "io/row_format.h"
#include "io/tiff_messages.h"
#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

/// A file in memory that libtiff writes, and its first complaint.
struct TiffTarget : TiffMessages {
  std::string bytes;
  std::size_t at = 0;
};

tmsize_t read_bytes(thandle_t handle, void* out, tmsize_t count) {
  auto& self = *static_cast<TiffTarget*>(handle);
  const std::size_t left = self.bytes.size() - std::min(self.at, self.bytes.size());
  const std::size_t taken = std::min(left, static_cast<std::size_t>(std::max<tmsize_t>(count, 0)));
  if (taken > 0) std::memcpy(out, self.bytes.data() + self.at, taken);
  self.at += taken;
  return static_cast<tmsize_t>(taken);
}

tmsize_t write_bytes(thandle_t handle, void* data, tmsize_t count) {
  auto& self = *static_cast<TiffTarget*>(handle);
  const auto length = static_cast<std::size_t>(std::max<tmsize_t>(count, 0));
  try {
    if (self.bytes.size() < self.at + length) self.bytes.resize(self.at + length);
  } catch (const std::exception&) {
    return 0;  // told as a fault by libtiff
  }
  if (length > 0) std::memcpy(self.bytes.data() + self.at, data, length);
  self.at += length;
  return count;
}

toff_t seek(thandle_t handle, toff_t offset, int whence) {
  auto& self = *static_cast<TiffTarget*>(handle);
  const std::size_t base =
      whence == SEEK_CUR ? self.at : (whence == SEEK_END ? self.bytes.size() : 0);
  self.at = base + static_cast<std::size_t>(offset);
  return self.at;
}

class TiffRowWriter final : public RowWriter {
 public:
  TiffRowWriter(const RowFormat& format, ByteSink sink) : format_(format), sink_(std::move(sink)) {
    check_row_format(format);
    if (format.bits == 1 && format.transparent) {
      throw std::invalid_argument("a TIFF of 1 bit a pixel has no transparency; take 8 bits");
    }
    const auto options = target_.open_options();
    tiff_.reset(TIFFClientOpenExt(
        "", "wm", &target_, read_bytes, write_bytes, seek, [](thandle_t) { return 0; },
        [](thandle_t handle) -> toff_t { return static_cast<TiffTarget*>(handle)->bytes.size(); },
        nullptr, nullptr, options.get()));
    if (!tiff_ || !describe()) fail();
  }

  void write(std::span<const std::uint8_t> gray) override {
    std::vector<std::uint8_t> samples = row_samples(gray, format_);
    // Group 4 files have black as 1.
    if (format_.bits == 1) {
      for (std::uint8_t& byte : samples) byte = static_cast<std::uint8_t>(~byte);
    }
    if (TIFFWriteScanline(tiff_.get(), samples.data(), row_++, 0) != 1) fail();
  }

  void finish() override {
    if (TIFFFlush(tiff_.get()) != 1) fail();
    tiff_.reset();
    if (target_.message[0] != '\0') fail();
    sink_(target_.bytes);
  }

 private:
  bool describe() {
    TIFF* const tiff = tiff_.get();
    const bool one_bit = format_.bits == 1;
    const int channels = format_.transparent ? 2 : 1;
    constexpr std::uint16_t kOpacity[] = {EXTRASAMPLE_ASSOCALPHA};
    return TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, format_.width) &&
           TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, format_.height) &&
           TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, format_.bits) &&
           TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, channels) &&
           TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) &&
           TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT) &&
           TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC,
                        one_bit ? PHOTOMETRIC_MINISWHITE : PHOTOMETRIC_MINISBLACK) &&
           TIFFSetField(tiff, TIFFTAG_COMPRESSION,
                        one_bit ? COMPRESSION_CCITTFAX4 : COMPRESSION_LZW) &&
           TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH) &&
           TIFFSetField(tiff, TIFFTAG_XRESOLUTION, format_.dpi) &&
           TIFFSetField(tiff, TIFFTAG_YRESOLUTION, format_.dpi) &&
           (channels == 1 || TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, kOpacity)) &&
           TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
  }

  [[noreturn]] void fail() {
    throw codec::OutputError(fmt::format("the TIFF image cannot be made: {}",
                                         target_.message[0] ? target_.message : "out of memory"),
                             "", "make the image smaller");
  }

  RowFormat format_;
  ByteSink sink_;
  TiffTarget target_;
  std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff_{nullptr, &TIFFClose};
  std::uint32_t row_ = 0;
};

}  // namespace

std::unique_ptr<RowWriter> tiff_row_writer(const RowFormat& format, ByteSink sink) {
  return std::make_unique<TiffRowWriter>(format, std::move(sink));
}

}  // namespace tagmint::io
