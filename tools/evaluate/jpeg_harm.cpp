#include "evaluate/jpeg_harm.h"

// jpeglib.h wants these two before it.
#include <cstddef>
#include <cstdio>
//
#include <jpeglib.h>

#include <cstdlib>
#include <memory>
#include <new>
#include <string_view>

#include "io/images.h"

namespace tagmint::evaluate {

detect::Image through_jpeg(const detect::Image& image, int quality) {
  jpeg_compress_struct compress{};
  jpeg_error_mgr errors{};
  compress.err = jpeg_std_error(&errors);
  // Only a lack of memory can go wrong here.
  errors.error_exit = [](j_common_ptr) { throw std::bad_alloc(); };
  jpeg_create_compress(&compress);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&compress, &bytes, &size);
  compress.image_width = static_cast<JDIMENSION>(image.width());
  compress.image_height = static_cast<JDIMENSION>(image.height());
  compress.input_components = 1;
  compress.in_color_space = JCS_GRAYSCALE;
  jpeg_set_defaults(&compress);
  jpeg_set_quality(&compress, quality, TRUE);
  jpeg_start_compress(&compress, TRUE);
  for (int y = 0; y < image.height(); ++y) {
    JSAMPROW row = const_cast<JSAMPROW>(image.row(y));  // it is only read
    jpeg_write_scanlines(&compress, &row, 1);
  }
  jpeg_finish_compress(&compress);
  jpeg_destroy_compress(&compress);
  const std::unique_ptr<unsigned char, decltype(&std::free)> owner(bytes, &std::free);
  return io::decode_gray_image({reinterpret_cast<const char*>(bytes), size}, "jpeg");
}

}  // namespace tagmint::evaluate
