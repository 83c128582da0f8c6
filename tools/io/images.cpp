#include "io/images.h"

#include <fmt/format.h>

#include "io/image_codecs.h"
#include "io/streams.h"
#include "tagmint/codec/atomic_file.h"
#include "tagmint/codec/errors.h"

namespace tagmint::io {

using namespace std::string_view_literals;

std::optional<ImageKind> image_kind(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return ImageKind::Png;
  if (bytes.starts_with("\xff\xd8\xff"sv)) return ImageKind::Jpeg;
  // Byte order, then 42; 43 is BigTIFF.
  for (const std::string_view mark : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
    if (bytes.starts_with(mark)) return ImageKind::Tiff;
  }
  if (bytes.size() >= 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '7') {
    return ImageKind::Pnm;
  }
  return std::nullopt;
}

void check_image_size(std::int64_t width, std::int64_t height, const std::string& source) {
  if (width < 1 || height < 1) {
    throw codec::InputError(fmt::format("the image is {} x {} pixels", width, height), source,
                            "it needs at least one pixel");
  }
  if (height > kMaxPixels / width) {
    throw codec::InputError(
        fmt::format("the image claims {} x {} pixels, more than the limit of {}", width, height,
                    kMaxPixels),
        source, "scale it down or cut it into parts");
  }
}

void throw_damaged(std::string_view kind, std::string_view reason, const std::string& source) {
  throw codec::InputError(fmt::format("the {} image is damaged: {}", kind, reason), source,
                          "save or copy the file again");
}

detect::Image decode_gray_image(std::string_view bytes, const std::string& source) {
  const std::optional<ImageKind> kind = image_kind(bytes);
  if (!kind) {
    throw codec::InputError(bytes.empty() ? "the image is empty" : "not an image of a known kind",
                            source, "give a PNG, JPEG, PNM or TIFF file");
  }
  switch (*kind) {
    case ImageKind::Pnm:
      return decode_pnm(bytes, source);
    case ImageKind::Png:
      return decode_png(bytes, source);
    case ImageKind::Jpeg:
      return decode_jpeg(bytes, source);
    case ImageKind::Tiff:
      break;
  }
  return decode_tiff(bytes, source);
}

detect::Image read_gray_image(const std::string& path) {
  return decode_gray_image(read_input(path), input_name(path));
}

void write_png(const std::filesystem::path& path, const detect::ImageView& image,
               std::optional<double> dpi) {
  codec::write_file_atomically(path, encode_png(image, dpi));
}

void write_png(const std::filesystem::path& path, const RgbImage& image,
               std::optional<double> dpi) {
  codec::write_file_atomically(path, encode_png(image, dpi));
}

void write_pnm(const std::filesystem::path& path, const detect::ImageView& image) {
  codec::write_file_atomically(path, encode_pnm(image));
}

void write_pnm(const std::filesystem::path& path, const RgbImage& image) {
  codec::write_file_atomically(path, encode_pnm(image));
}

}  // namespace tagmint::io
