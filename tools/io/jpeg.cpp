// JPEG through libjpeg. As in png.cpp, faults come by longjmp, and what changes lives in an object
// of the caller.
#include <csetjmp>
#include <cstdio>
// jpeglib.h needs FILE, so it follows <cstdio>.
#include <jerror.h>
#include <jpeglib.h>

#include <new>
#include <vector>

#include "io/gray.h"
#include "io/image_codecs.h"

namespace tagmint::io {
namespace {

/// Owns libjpeg's structures, and all that changes while they are in use.
struct JpegReader {
  jpeg_decompress_struct jpeg = {};
  jpeg_error_mgr errors = {};
  jpeg_source_mgr input = {};
  std::jmp_buf on_fault = {};
  char message[JMSG_LENGTH_MAX] = {};
  const std::string& source;
  std::vector<JSAMPLE> samples;  // one row of four-colour samples
  detect::Image image;

  JpegReader(std::string_view bytes, const std::string& name);
  ~JpegReader() { jpeg_destroy_decompress(&jpeg); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;
};

[[noreturn]] void on_error(j_common_ptr common) {
  auto& self = *static_cast<JpegReader*>(common->client_data);
  common->err->format_message(common, self.message);
  std::longjmp(self.on_fault, 1);
}

/// Warnings that mean lost pixels are faults; the others, such as an odd version number, are not.
void on_message(j_common_ptr common, int level) {
  if (level >= 0) return;
  switch (common->err->msg_code) {
    case JWRN_HIT_MARKER:
    case JWRN_HUFF_BAD_CODE:
    case JWRN_JPEG_EOF:
    case JWRN_MUST_RESYNC:
      on_error(common);
    default:
      return;
  }
}

/// All bytes are in memory from the start: wanting more means that the file is cut.
boolean on_end(j_decompress_ptr jpeg) {
  jpeg->err->msg_code = JERR_INPUT_EOF;
  on_error(reinterpret_cast<j_common_ptr>(jpeg));
}

void skip(j_decompress_ptr jpeg, long count) {
  if (count <= 0) return;
  if (static_cast<std::size_t>(count) > jpeg->src->bytes_in_buffer) on_end(jpeg);
  jpeg->src->next_input_byte += count;
  jpeg->src->bytes_in_buffer -= static_cast<std::size_t>(count);
}

JpegReader::JpegReader(std::string_view bytes, const std::string& name) : source(name) {
  jpeg.err = jpeg_std_error(&errors);
  jpeg.client_data = this;
  errors.error_exit = on_error;
  errors.emit_message = on_message;
  errors.output_message = [](j_common_ptr) {};
  input.next_input_byte = reinterpret_cast<const JOCTET*>(bytes.data());
  input.bytes_in_buffer = bytes.size();
  input.init_source = [](j_decompress_ptr) {};
  input.fill_input_buffer = on_end;
  input.skip_input_data = skip;
  input.resync_to_restart = jpeg_resync_to_restart;
  input.term_source = [](j_decompress_ptr) {};
}

/// A row of cyan, magenta, yellow, black samples as gray. Adobe's programs write them inverted.
void inks_to_gray(const JSAMPLE* inks, int width, bool inverted, std::uint8_t* gray) {
  const std::uint32_t flip = inverted ? 0 : 255;
  for (int x = 0; x < width; ++x, inks += 4) {
    const std::uint32_t black = inks[3] ^ flip;
    const auto mixed = [&](int i) { return ((inks[i] ^ flip) * black + 127) / 255; };
    gray[x] = static_cast<std::uint8_t>(luma(mixed(0), mixed(1), mixed(2)));
  }
}

/// Decodes into `self.image`. False when libjpeg found a fault, told in `self.message`.
bool read_pixels(JpegReader& self) {
  if (setjmp(self.on_fault)) return false;
  jpeg_decompress_struct& jpeg = self.jpeg;
  jpeg_create_decompress(&jpeg);
  jpeg.src = &self.input;
  jpeg_read_header(&jpeg, TRUE);
  check_image_size(jpeg.image_width, jpeg.image_height, self.source);
  const bool inks = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
  jpeg.out_color_space = inks ? JCS_CMYK : JCS_GRAYSCALE;
  jpeg_start_decompress(&jpeg);
  self.image.resize(static_cast<int>(jpeg.output_width), static_cast<int>(jpeg.output_height));
  if (inks) self.samples.resize(std::size_t{4} * jpeg.output_width);
  while (jpeg.output_scanline < jpeg.output_height) {
    std::uint8_t* const gray = self.image.row(static_cast<int>(jpeg.output_scanline));
    JSAMPROW row = inks ? self.samples.data() : gray;
    jpeg_read_scanlines(&jpeg, &row, 1);
    if (inks) inks_to_gray(row, self.image.width(), jpeg.saw_Adobe_marker, gray);
  }
  jpeg_finish_decompress(&jpeg);
  return true;
}

}  // namespace

detect::Image decode_jpeg(std::string_view bytes, const std::string& source) {
  JpegReader reader(bytes, source);
  if (!read_pixels(reader)) throw_damaged("JPEG", reader.message, source);
  return std::move(reader.image);
}

}  // namespace tagmint::io
