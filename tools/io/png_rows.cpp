// PNG row by row through libpng. The library reports faults by longjmp: the functions that call
// setjmp hold nothing with a destructor, and what the sink throws is kept until they are left.
#include <fmt/format.h>
#include <png.h>

#include <cmath>
#include <csetjmp>
#include <cstring>
#include <exception>

#include "io/row_format.h"
#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

class PngRowWriter final : public RowWriter {
 public:
  PngRowWriter(const RowFormat& format, ByteSink sink) : format_(format), sink_(std::move(sink)) {
    check_row_format(format);
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, on_error, [](auto, auto) {});
    if (png_) info_ = png_create_info_struct(png_);
    if (!info_) {
      png_destroy_write_struct(&png_, &info_);
      throw std::bad_alloc();
    }
    png_set_write_fn(png_, this, take, [](png_structp) {});
    if (!start()) fail();
  }
  ~PngRowWriter() override { png_destroy_write_struct(&png_, &info_); }

  void write(std::span<const std::uint8_t> gray) override {
    samples_ = row_samples(gray, format_);
    if (!put_row()) fail();
  }
  void finish() override {
    if (!end()) fail();
  }

 private:
  static void on_error(png_structp png, png_const_charp text) {
    auto& self = *static_cast<PngRowWriter*>(png_get_error_ptr(png));
    std::strncpy(self.message_, text, sizeof(self.message_) - 1);
    png_longjmp(png, 1);
  }
  static void take(png_structp png, png_bytep data, std::size_t count) {
    auto& self = *static_cast<PngRowWriter*>(png_get_io_ptr(png));
    if (!self.hand_on(data, count)) png_error(png, "the file cannot be written");
  }
  bool hand_on(const png_byte* data, std::size_t count) noexcept {
    try {
      sink_({reinterpret_cast<const char*>(data), count});
      return true;
    } catch (...) {
      thrown_ = std::current_exception();
      return false;
    }
  }

  bool start() {
    constexpr double kMetresAnInch = 0.0254;
    const auto pixels_a_metre = static_cast<png_uint_32>(std::lround(format_.dpi / kMetresAnInch));
    const bool two_channels = format_.transparent && format_.bits == 8;
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(format_.width),
                 static_cast<png_uint_32>(format_.height), format_.bits,
                 two_channels ? PNG_COLOR_TYPE_GRAY_ALPHA : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (format_.transparent && format_.bits == 1) {
      png_color_16 white = {};
      white.gray = 1;
      png_set_tRNS(png_, info_, nullptr, 0, &white);
    }
    png_set_pHYs(png_, info_, pixels_a_metre, pixels_a_metre, PNG_RESOLUTION_METER);
    png_write_info(png_, info_);
    return true;
  }
  bool put_row() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_write_row(png_, samples_.data());
    return true;
  }
  bool end() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_write_end(png_, nullptr);
    return true;
  }

  [[noreturn]] void fail() {
    if (thrown_) std::rethrow_exception(thrown_);
    throw codec::OutputError(fmt::format("the PNG image cannot be made: {}", message_), "",
                             "make the image smaller");
  }

  RowFormat format_;
  ByteSink sink_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  char message_[160] = {};
  std::exception_ptr thrown_;
  std::vector<std::uint8_t> samples_;
};

}  // namespace

std::unique_ptr<RowWriter> png_row_writer(const RowFormat& format, ByteSink sink) {
  return std::make_unique<PngRowWriter>(format, std::move(sink));
}

}  // namespace tagmint::io
