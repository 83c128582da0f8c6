// PNM: a text header, then samples as bytes or as decimal numbers.
#include <fmt/format.h>

#include <stdexcept>

#include "io/gray.h"
#include "io/image_codecs.h"
#include "io/images.h"
#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

constexpr std::uint32_t kMaxSample = 65535;

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Walks over the bytes of a PNM file.
class PnmCursor {
 public:
  PnmCursor(std::string_view bytes, const std::string& source) : bytes_(bytes), source_(source) {}

  /// The next decimal number, after white space and comments ('#' to the end of the line).
  std::uint32_t number(std::uint32_t largest, std::string_view what) {
    skip_blanks();
    if (at_ == bytes_.size()) throw_damaged("PNM", fmt::format("it ends before {}", what), source_);
    std::uint32_t value = 0;
    const std::size_t start = at_;
    for (; at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9'; ++at_) {
      value = value * 10 + static_cast<std::uint32_t>(bytes_[at_] - '0');
      if (value > largest) {
        throw_damaged("PNM", fmt::format("{} is larger than {}", what, largest), source_);
      }
    }
    if (at_ == start) throw_damaged("PNM", fmt::format("{} is not a number", what), source_);
    return value;
  }

  /// The one white space character that ends the header of a binary file.
  void end_header() {
    if (at_ == bytes_.size() || !is_space(bytes_[at_])) {
      throw_damaged("PNM", "white space is missing after the largest sample value", source_);
    }
    ++at_;
  }

  std::string_view rest() const { return bytes_.substr(at_); }

 private:
  void skip_blanks() {
    while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
      if (bytes_[at_++] != '#') continue;
      while (at_ < bytes_.size() && bytes_[at_] != '\n' && bytes_[at_] != '\r') ++at_;
    }
  }

  std::string_view bytes_;
  const std::string& source_;
  std::size_t at_ = 2;  // after the kind, "P5"
};

/// The samples of a binary file, one or two bytes each, high byte first.
class BinarySamples {
 public:
  BinarySamples(std::string_view bytes, std::uint32_t top) : next_(bytes.data()), top_(top) {}
  std::uint32_t operator()() {
    std::uint32_t value = static_cast<unsigned char>(*next_++);
    if (top_ > 255) value = value << 8 | static_cast<unsigned char>(*next_++);
    return value < top_ ? value : top_;
  }

 private:
  const char* next_;
  std::uint32_t top_;
};

template <class Samples>
void fill(detect::Image& image, bool colour, std::uint32_t top, Samples&& next) {
  for (int y = 0; y < image.height(); ++y) {
    std::uint8_t* const row = image.row(y);
    for (int x = 0; x < image.width(); ++x) {
      std::uint32_t value = next();
      if (colour) {
        const std::uint32_t green = next();
        value = luma(value, green, next());
      }
      row[x] = to_8_bits(value, top);
    }
  }
}

std::string header(char kind, int width, int height) {
  if (width < 1 || height < 1) {
    throw std::invalid_argument(fmt::format(
        "an image of {} x {} pixels cannot be written; sides are 1 or more", width, height));
  }
  return fmt::format("P{}\n{} {}\n255\n", kind, width, height);
}

}  // namespace

detect::Image decode_pnm(std::string_view bytes, const std::string& source) {
  const char kind = bytes[1];
  if (kind != '2' && kind != '3' && kind != '5' && kind != '6') {
    throw codec::InputError(fmt::format("PNM images of kind P{} are not read", kind), source,
                            "save it as P2, P3, P5 or P6, for example with pnmtopng or convert");
  }
  const bool colour = kind == '3' || kind == '6';
  constexpr std::uint32_t kMaxSide = std::uint32_t{1} << 28;
  PnmCursor cursor(bytes, source);
  const std::uint32_t width = cursor.number(kMaxSide, "the width");
  const std::uint32_t height = cursor.number(kMaxSide, "the height");
  check_image_size(width, height, source);
  const std::uint32_t top = cursor.number(kMaxSample, "the largest sample value");
  if (top == 0) throw_damaged("PNM", "the largest sample value is 0", source);
  const std::uint64_t samples = std::uint64_t{width} * height * (colour ? 3 : 1);

  // Every sample takes at least a byte (two as text, except the last): a short file is refused
  // before memory is taken for what it claims.
  const bool binary = kind == '5' || kind == '6';
  if (binary) cursor.end_header();
  const std::uint64_t needed = binary ? samples * (top > 255 ? 2 : 1) : samples * 2 - 1;
  if (cursor.rest().size() < needed) {
    throw_damaged("PNM",
                  fmt::format("{} bytes of samples are needed at least and {} are there", needed,
                              cursor.rest().size()),
                  source);
  }

  detect::Image image(static_cast<int>(width), static_cast<int>(height));
  if (binary) {
    fill(image, colour, top, BinarySamples(cursor.rest(), top));
  } else {
    fill(image, colour, top, [&] { return cursor.number(top, "a sample"); });
  }
  return image;
}

std::string encode_pnm(const detect::ImageView& image) {
  std::string out = header('5', image.width, image.height);
  out.reserve(out.size() + std::size_t(image.width) * image.height);
  for (int y = 0; y < image.height; ++y) {
    out.append(reinterpret_cast<const char*>(image.row(y)), std::size_t(image.width));
  }
  return out;
}

std::string encode_pnm(const RgbImage& image) {
  std::string out = header('6', image.width, image.height);
  return out.append(reinterpret_cast<const char*>(image.rgb.data()), image.rgb.size());
}

}  // namespace tagmint::io
