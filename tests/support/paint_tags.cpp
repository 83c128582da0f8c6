#include "support/paint_tags.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tagmint/codec/rotation.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::testing {
namespace {

using codec::Cell;
using detect::Homography;
using detect::Point;

constexpr int kSamples = 64;

/// Bits of a six-bit number in reverse order, as a fraction.
double radical_inverse(int i) {
  double value = 0;
  for (int bit = 0; bit < 6; ++bit) value += ((i >> bit) & 1) / double(2 << bit);
  return value;
}

/// The picture of a tag: which cell a place of the tag plane lies in, and what is printed there.
class TagPicture {
 public:
  TagPicture(const codec::Family& family, codec::TagId id, const Ink& ink)
      : layout_(family.layout()),
        cells_(codec::tag_cells(family.layout(), family.codeword(id))),
        ink_(ink) {}

  /// Column and row; cells of the surround and beyond count on in both directions.
  codec::CellPosition cell_at(Point p) const {
    const double cells_per_unit = layout_.width_at_border() / 2.0;
    return {static_cast<int>(std::floor((p.x + 1) * cells_per_unit)) + layout_.border_offset(),
            static_cast<int>(std::floor((p.y + 1) * cells_per_unit)) + layout_.border_offset()};
  }

  /// Nothing where nothing is printed.
  std::optional<double> gray(codec::CellPosition p) const {
    const int width = layout_.width();
    if (p.x >= 0 && p.y >= 0 && p.x < width && p.y < width) {
      const Cell cell = cells_.at(p.x, p.y);
      if (cell != Cell::None) return cell == Cell::White ? ink_.white : ink_.black;
    }
    const int outside = std::max({-p.x, -p.y, p.x - width + 1, p.y - width + 1});
    if (outside <= ink_.quiet_cells) return ink_.white;
    return std::nullopt;
  }

  /// Half the side of everything painted, in units of the tag plane.
  double reach() const {
    return (layout_.width() / 2.0 + ink_.quiet_cells) * 2 / layout_.width_at_border();
  }

 private:
  const codec::Layout& layout_;
  codec::TagCells cells_;
  Ink ink_;
};

}  // namespace

void paint_tag(Canvas& canvas, const codec::Family& family, codec::TagId id,
               const Homography& tag_to_image, const Ink& ink) {
  const TagPicture picture(family, id, ink);
  const Homography to_tag = tag_to_image.inverse().value();
  double left = canvas.width, right = 0, top = canvas.height, bottom = 0;
  for (const Point corner : detect::kTagCorners) {
    const Point p = tag_to_image.project(picture.reach() * corner);
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  const int x_end = std::min(canvas.width, static_cast<int>(std::ceil(right)));
  const int y_end = std::min(canvas.height, static_cast<int>(std::ceil(bottom)));
  for (int y = std::max(0, static_cast<int>(top)); y < y_end; ++y) {
    for (int x = std::max(0, static_cast<int>(left)); x < x_end; ++x) {
      const auto cell_at = [&](double dx, double dy) {
        return picture.cell_at(to_tag.project({x + dx, y + dy}));
      };
      const auto gray = [&](codec::CellPosition cell) {
        return picture.gray(cell).value_or(canvas.at(x, y));
      };
      // A cell's image is convex: with all four corners of a pixel in it, so is the whole pixel.
      const codec::CellPosition first = cell_at(0, 0);
      if (cell_at(1, 0) == first && cell_at(0, 1) == first && cell_at(1, 1) == first) {
        canvas.at(x, y) = static_cast<float>(gray(first));
        continue;
      }
      double sum = 0;
      for (int i = 0; i < kSamples; ++i) {
        sum += gray(cell_at((i + 0.5) / kSamples, radical_inverse(i) + 0.5 / kSamples));
      }
      canvas.at(x, y) = static_cast<float>(sum / kSamples);
    }
  }
}

void blur(Canvas& canvas, double sigma_px) {
  const int reach = static_cast<int>(std::ceil(4 * sigma_px));
  std::vector<double> kernel;
  double total = 0;
  for (int i = -reach; i <= reach; ++i) {
    kernel.push_back(std::exp(-i * i / (2 * sigma_px * sigma_px)));
    total += kernel.back();
  }
  const auto pass = [&](int dx, int dy) {
    const Canvas before = canvas;
    for (int y = 0; y < canvas.height; ++y) {
      for (int x = 0; x < canvas.width; ++x) {
        double sum = 0;
        for (int i = -reach; i <= reach; ++i) {
          sum += kernel[i + reach] * before.at(std::clamp(x + i * dx, 0, canvas.width - 1),
                                               std::clamp(y + i * dy, 0, canvas.height - 1));
        }
        canvas.at(x, y) = static_cast<float>(sum / total);
      }
    }
  };
  pass(1, 0);
  pass(0, 1);
}

detect::Image to_gray(const Canvas& canvas, double noise_sigma, FixedRandom& random) {
  detect::Image image(canvas.width, canvas.height);
  for (int y = 0; y < canvas.height; ++y) {
    for (int x = 0; x < canvas.width; ++x) {
      const double noise = noise_sigma > 0 ? noise_sigma * random.normal() : 0.0;
      image.at(x, y) =
          static_cast<std::uint8_t>(std::clamp(std::round(canvas.at(x, y) + noise), 0.0, 255.0));
    }
  }
  return image;
}

Homography square_at(Point centre, double side_px, double angle_rad) {
  const double c = side_px / 2 * std::cos(angle_rad);
  const double s = side_px / 2 * std::sin(angle_rad);
  return Homography({c, -s, centre.x, s, c, centre.y, 0, 0, 1});
}

Homography tilted_square_at(Point centre, double side_px, double angle_rad, double tilt_rad,
                            double axis_rad, double distance_sides) {
  // Turn the square in its plane so that the tilt axis is x, lean it back about x, turn it back.
  detect::Corners corners;
  for (int i = 0; i < 4; ++i) {
    const Point p =
        square_at({0, 0}, side_px, angle_rad - axis_rad).project(detect::kTagCorners[i]);
    const double depth = distance_sides * side_px - p.y * std::sin(tilt_rad);
    const double scale = distance_sides * side_px / depth;
    const Point leant = {scale * p.x, scale * p.y * std::cos(tilt_rad)};
    corners[i] = centre + Point{leant.x * std::cos(axis_rad) - leant.y * std::sin(axis_rad),
                                leant.x * std::sin(axis_rad) + leant.y * std::cos(axis_rad)};
  }
  return Homography::from_corners(corners).value();
}

detect::Corners corners_of(const Homography& tag_to_image) {
  detect::Corners corners;
  for (int i = 0; i < 4; ++i) corners[i] = tag_to_image.project(detect::kTagCorners[i]);
  return corners;
}

codec::SharedFamily random_family(const std::string& name, const codec::Layout& layout,
                                  int min_hamming, int codes, std::uint64_t seed) {
  FixedRandom random(seed);
  const int bits = layout.bits();
  std::vector<codec::Codeword> words;
  for (int trial = 0; trial < 20000 && static_cast<int>(words.size()) < codes; ++trial) {
    const codec::Codeword word = random.bits() & codec::low_mask(bits);
    const bool apart = std::all_of(words.begin(), words.end(), [&](codec::Codeword other) {
      return codec::rotation_distance(word, other, bits) >= min_hamming;
    });
    if (apart && codec::self_distance(word, bits) >= min_hamming) words.push_back(word);
  }
  return std::make_shared<const codec::Family>(codec::FamilyParts{.name = name,
                                                                  .layout = layout,
                                                                  .min_hamming = min_hamming,
                                                                  .codewords = words,
                                                                  .complexity = {},
                                                                  .origin = {},
                                                                  .levels = {}});
}

}  // namespace tagmint::testing
