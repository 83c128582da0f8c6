// PNG through libpng's simplified interface, which reports faults by its return values.
#include "io/family_kinds/cell_png.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cstdint>
#include <new>

#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

using codec::Cell;

constexpr png_uint_32 kMostWidth = 64;  // of a Layout

/// libpng's structure, freed at the end.
struct PngImage : png_image {
  PngImage() : png_image{} { version = PNG_IMAGE_VERSION; }
  ~PngImage() { png_image_free(this); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
};

[[noreturn]] void throw_no_tag(std::string_view what, const std::string& source) {
  throw codec::InputError(what, source, "a tag is a PNG picture with one pixel a cell");
}

/// A pixel of gray and opacity as a cell. Some programs write gray for black and white by rounding.
Cell cell_of(std::uint8_t gray, std::uint8_t opacity, std::size_t place, int width,
             const std::string& source) {
  constexpr int kDark = 64;
  constexpr int kLight = 191;
  if (opacity < kDark) return Cell::None;
  if (opacity > kLight && gray < kDark) return Cell::Black;
  if (opacity > kLight && gray > kLight) return Cell::White;
  throw_no_tag(
      fmt::format("the pixel ({}, {}) is neither black nor white nor transparent",
                  place % static_cast<std::size_t>(width), place / static_cast<std::size_t>(width)),
      source);
}

}  // namespace

std::string encode_cell_png(const CellPicture& picture) {
  const bool transparent =
      std::find(picture.cells.begin(), picture.cells.end(), Cell::None) != picture.cells.end();
  std::vector<std::uint8_t> samples;
  samples.reserve(picture.cells.size() * (transparent ? 2 : 1));
  for (const Cell cell : picture.cells) {
    samples.push_back(cell == Cell::White ? 255 : 0);
    if (transparent) samples.push_back(cell == Cell::None ? 0 : 255);
  }
  PngImage image;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = transparent ? PNG_FORMAT_GA : PNG_FORMAT_GRAY;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, samples.data(), 0, nullptr)) {
    throw codec::OutputError(fmt::format("the PNG image cannot be made: {}", image.message), "",
                             "make the family smaller");
  }
  bytes.resize(size);
  return bytes;
}

codec::TagCells decode_cell_png(std::string_view bytes, const std::string& source) {
  PngImage image;
  if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size())) {
    throw_no_tag(fmt::format("no PNG image: {}", image.message), source);
  }
  if (image.width != image.height || image.width > kMostWidth) {
    throw_no_tag(fmt::format("{} x {} pixels are no square of up to {} cells", image.width,
                             image.height, kMostWidth),
                 source);
  }
  image.format = PNG_FORMAT_GA;
  std::vector<std::uint8_t> samples(PNG_IMAGE_SIZE(image));
  if (!png_image_finish_read(&image, nullptr, samples.data(), 0, nullptr)) {
    throw_no_tag(fmt::format("the PNG image is damaged: {}", image.message), source);
  }
  const int width = static_cast<int>(image.width);
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < samples.size(); i += 2) {
    cells.push_back(cell_of(samples[i], samples[i + 1], i / 2, width, source));
  }
  return codec::TagCells(width, std::move(cells));
}

}  // namespace tagmint::io
