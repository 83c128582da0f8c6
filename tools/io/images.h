#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tagmint/detect/image.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::io {

/// Most pixels of an image that is read: a small file cannot ask for all the memory.
inline constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;

/// A colour image: 3 bytes a pixel (red, green, blue), rows without padding.
struct RgbImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  RgbImage() = default;
  RgbImage(int w, int h) : width(w), height(h), rgb(std::size_t(w) * h * 3) {}
  std::uint8_t* pixel(int x, int y) { return rgb.data() + (std::size_t(y) * width + x) * 3; }
  const std::uint8_t* pixel(int x, int y) const {
    return rgb.data() + (std::size_t(y) * width + x) * 3;
  }
};

/// The kinds of image files that are read.
enum class ImageKind { Pnm, Png, Jpeg, Tiff };

/// The kind that the first bytes of a file show, whatever the file's name.
std::optional<ImageKind> image_kind(std::string_view bytes);

/// Reads an image file as gray: PNG, JPEG, PNM (P2 P3 P5 P6) or TIFF, 1 to 16 bits a sample, gray,
/// colour or palette. Colour becomes Rec. 601 luma, transparency is seen over white, 16 bits are
/// rounded to 8. Gamma, colour profiles and the orientation note of cameras are not applied: pixels
/// stay where the file has them. Of a file with several pictures the first is read.
///   path     "-" is the standard input
/// Throws codec::InputError naming the file: unreadable, of another kind, malformed, cut short,
/// or more than kMaxPixels.
detect::Image read_gray_image(const std::string& path);

/// The same for the content of a file.
///   source   name used in messages, for example the path
detect::Image decode_gray_image(std::string_view bytes, const std::string& source);

/// The image as the content of a PNG file, 8 bits a sample.
///   dpi      pixels per inch to note in the file, > 0
/// Throws std::invalid_argument for an empty image or a dpi that is not positive.
std::string encode_png(const detect::ImageView& image, std::optional<double> dpi = {});
std::string encode_png(const RgbImage& image, std::optional<double> dpi = {});

/// The image as the content of a binary PNM file: gray P5, colour P6.
std::string encode_pnm(const detect::ImageView& image);
std::string encode_pnm(const RgbImage& image);

/// The image as the content of a JPEG file.
///   quality  1 (coarsest) .. 100, libjpeg's scale
/// Throws std::invalid_argument for another quality, an empty image or a side of more than 65500
/// px.
std::string encode_jpeg(const detect::ImageView& image, int quality);

/// Write an image file: whole or not at all. Throws codec::OutputError, and std::invalid_argument
/// as encode_png() does.
void write_png(const std::filesystem::path& path, const detect::ImageView& image,
               std::optional<double> dpi = {});
void write_png(const std::filesystem::path& path, const RgbImage& image,
               std::optional<double> dpi = {});
void write_pnm(const std::filesystem::path& path, const detect::ImageView& image);
void write_pnm(const std::filesystem::path& path, const RgbImage& image);

}  // namespace tagmint::io
