// JPEG through libjpeg. As in jpeg.cpp, faults come by longjmp, and what changes lives in an object
// of the caller.
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
// jpeglib.h needs FILE, so it follows <cstdio>.
#include <fmt/format.h>
#include <jpeglib.h>

#include <new>
#include <stdexcept>

#include "io/images.h"

namespace tagmint::io {
namespace {

/// Owns libjpeg's structures and what it has written.
struct JpegWriter {
  jpeg_compress_struct jpeg = {};
  jpeg_error_mgr errors = {};
  std::jmp_buf on_fault = {};
  unsigned char* bytes = nullptr;
  unsigned long size = 0;

  JpegWriter() {
    jpeg.err = jpeg_std_error(&errors);
    jpeg.client_data = this;
    errors.error_exit = [](j_common_ptr common) {
      std::longjmp(static_cast<JpegWriter*>(common->client_data)->on_fault, 1);
    };
    errors.output_message = [](j_common_ptr) {};
  }
  ~JpegWriter() {
    jpeg_destroy_compress(&jpeg);
    std::free(bytes);
  }
  JpegWriter(const JpegWriter&) = delete;
  JpegWriter& operator=(const JpegWriter&) = delete;
};

/// False when libjpeg gave up: there is no memory, as arguments were checked before.
bool write_pixels(JpegWriter& self, const detect::ImageView& image, int quality) {
  if (setjmp(self.on_fault)) return false;
  jpeg_compress_struct& jpeg = self.jpeg;
  jpeg_create_compress(&jpeg);
  jpeg_mem_dest(&jpeg, &self.bytes, &self.size);
  jpeg.image_width = static_cast<JDIMENSION>(image.width);
  jpeg.image_height = static_cast<JDIMENSION>(image.height);
  jpeg.input_components = 1;
  jpeg.in_color_space = JCS_GRAYSCALE;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, quality, TRUE);
  jpeg_start_compress(&jpeg, TRUE);
  while (jpeg.next_scanline < jpeg.image_height) {
    // libjpeg only reads the row.
    auto* row = const_cast<JSAMPLE*>(image.row(static_cast<int>(jpeg.next_scanline)));
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  return true;
}

}  // namespace

std::string encode_jpeg(const detect::ImageView& image, int quality) {
  constexpr int kMostSide = JPEG_MAX_DIMENSION;
  if (quality < 1 || quality > 100) {
    throw std::invalid_argument(
        fmt::format("a JPEG quality of {} cannot be; it is from 1 to 100", quality));
  }
  if (image.width < 1 || image.height < 1 || image.width > kMostSide || image.height > kMostSide) {
    throw std::invalid_argument(fmt::format("a JPEG image has sides of 1 to {} px, not {} x {}",
                                            kMostSide, image.width, image.height));
  }
  JpegWriter writer;
  if (!write_pixels(writer, image, quality)) throw std::bad_alloc();
  return std::string(reinterpret_cast<const char*>(writer.bytes), writer.size);
}

}  // namespace tagmint::io
