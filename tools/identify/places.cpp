#include "identify/places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "identify/reduce.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/detect/detector.h"

namespace tagmint::identify {
namespace {

using detect::Corners;
using detect::ImageView;
using detect::Point;

/// Takes the quads of one picture.
class QuadSink : public detect::DebugSink {
 public:
  void refined_quads(std::span<const Corners> quads) override {
    places.clear();
    for (const Corners& quad : quads) places.push_back({quad});
  }
  std::vector<Place> places;
};

/// A decoder that only tells the detector which kind of border to look for, and that its cells may
/// be small.
std::shared_ptr<const codec::Decoder> border_of(codec::Layout layout) {
  codec::FamilyParts parts{.name = "border",
                           .layout = std::move(layout),
                           .min_hamming = 1,
                           .codewords = {0},
                           .complexity = {},
                           .origin = {},
                           .levels = {}};
  return std::make_shared<const codec::Decoder>(
      std::make_shared<const codec::Family>(std::move(parts)));
}

/// The square from (left, top), clockwise from there on as a detector gives it: bottom left first.
Corners upright_square(double left, double top, double width, double height) {
  return {{{left, top + height}, {left + width, top + height}, {left + width, top}, {left, top}}};
}

/// Black or white, pixel by pixel, of a picture that has only two gray levels.
class TwoLevels {
 public:
  /// Nothing for a picture of more levels, or one.
  static std::optional<TwoLevels> of(ImageView picture) {
    constexpr int kLeastContrast = 32;
    /// Gray levels are near to one of two when they are in the outer quarters between them; so many
    /// pixels, in thousandths, must be.
    constexpr std::int64_t kLeastShare = 980;
    std::array<std::int64_t, 256> histogram{};
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) ++histogram[picture.at(x, y)];
    }
    const auto occurs = [](std::int64_t count) { return count > 0; };
    const auto lowest = std::find_if(histogram.begin(), histogram.end(), occurs);
    const auto highest = std::find_if(histogram.rbegin(), histogram.rend(), occurs);
    if (lowest == histogram.end()) return std::nullopt;
    const int low = static_cast<int>(lowest - histogram.begin());
    const int high = static_cast<int>(histogram.rend() - highest) - 1;
    if (high - low < kLeastContrast) return std::nullopt;
    std::int64_t near = 0;
    for (int gray = low; gray <= high; ++gray) {
      const int from_end = std::min(gray - low, high - gray);
      if (4 * from_end <= high - low) near += histogram[gray];
    }
    const std::int64_t pixels = std::int64_t{picture.width} * picture.height;
    if (near * 1000 < kLeastShare * pixels) return std::nullopt;
    return TwoLevels(picture, (low + high) / 2);
  }

  int width() const { return picture_.width; }
  int height() const { return picture_.height; }
  bool contains(int x, int y) const {
    return x >= 0 && y >= 0 && x < picture_.width && y < picture_.height;
  }
  bool light(int x, int y) const { return picture_.at(x, y) > middle_; }

 private:
  TwoLevels(ImageView picture, int middle) : picture_(picture), middle_(middle) {}

  ImageView picture_;
  int middle_;
};

/// A grid of cells of whole pixels.
struct Grid {
  int left = 0;  ///< of the border square, px
  int top = 0;
  int cell_px = 1;
  int cells = 0;  ///< along the border square
};

/// Whether the four corner pixels of a cell, as far as they are in the picture, have that colour.
bool cell_is(const TwoLevels& picture, const Grid& grid, int column, int row, bool light) {
  const int left = grid.left + column * grid.cell_px;
  const int top = grid.top + row * grid.cell_px;
  const int right = left + grid.cell_px - 1;
  const int bottom = top + grid.cell_px - 1;
  const auto is = [&](int x, int y) {
    return !picture.contains(x, y) || picture.light(x, y) == light;
  };
  return is(left, top) && is(right, bottom) && is(right, top) && is(left, bottom);
}

/// Whether all cells of the ring from (first, first) to (last, last) have that colour.
bool ring_is(const TwoLevels& picture, const Grid& grid, int first, int last, bool light) {
  for (int i = first; i < last; ++i) {
    if (!cell_is(picture, grid, i, first, light) || !cell_is(picture, grid, last, i, light) ||
        !cell_is(picture, grid, i + 1, last, light) ||
        !cell_is(picture, grid, first, i + 1, light)) {
      return false;
    }
  }
  return true;
}

bool has_border(const TwoLevels& picture, const Grid& grid) {
  const bool light = picture.light(grid.left, grid.top);
  return ring_is(picture, grid, -1, grid.cells, !light) &&
         ring_is(picture, grid, 0, grid.cells - 1, light);
}

/// A part of a picture; px.
struct Part {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  friend bool operator==(const Part&, const Part&) = default;
};

/// The smallest part that holds all pixels on one side of the middle gray level.
Part box_of(ImageView picture, int middle, bool light) {
  int left = picture.width, right = -1, top = picture.height, bottom = -1;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if ((picture.at(x, y) > middle) != light) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  return {left, top, right + 1 - left, bottom + 1 - top};
}

/// The whole picture, and its parts without dark and without light margins, each once.
std::vector<Part> parts_of(ImageView picture) {
  std::uint8_t low = 255, high = 0;
  for (int y = 0; y < picture.height; ++y) {
    const auto [least, most] = std::minmax_element(picture.row(y), picture.row(y) + picture.width);
    low = std::min(low, *least);
    high = std::max(high, *most);
  }
  std::vector<Part> parts = {{0, 0, picture.width, picture.height}};
  if (low == high) return parts;
  for (const bool light : {false, true}) {
    const Part part = box_of(picture, (low + high) / 2, light);
    if (std::find(parts.begin(), parts.end(), part) == parts.end()) parts.push_back(part);
  }
  return parts;
}

/// Whether the part is as high as wide, as nearly as cutting out by hand gets it: half a cell of
/// ten.
bool nearly_square(const Part& part) {
  return std::abs(part.width - part.height) * 20 <= std::max(part.width, part.height);
}

/// Every border that has the shape of one; what is in it, and where exactly, is not asked for here.
detect::DetectorOptions square_options(int threads) {
  detect::DetectorOptions options;
  options.algorithm = detect::Algorithm::Paper;
  options.read_harder = false;
  options.refine_photometric = false;
  options.threads = threads;
  return options;
}

}  // namespace

struct SquareFinder::Impl {
  explicit Impl(int threads)
      : detector({border_of(codec::classic_layout(12)), border_of(codec::standard_layout(9))},
                 square_options(threads)) {}

  detect::Detector detector;
};

SquareFinder::SquareFinder(int threads) : impl_(std::make_unique<Impl>(threads)) {}
SquareFinder::~SquareFinder() = default;

std::vector<Place> SquareFinder::find(ImageView picture) {
  QuadSink sink;
  impl_->detector.detect(picture, nullptr, &sink);
  return std::move(sink.places);
}

std::vector<Place> SquareFinder::find_at_edges(ImageView picture) {
  // Wide enough for the detector to see black or white beyond the edge.
  constexpr int kMargin_px = 16;
  std::vector<Place> places;
  for (const std::uint8_t gray : {255, 0}) {
    const detect::Image larger = with_margin(picture, kMargin_px, gray);
    for (Place& place : find(larger)) {
      for (Point& corner : place.corners) corner = corner - Point{kMargin_px, kMargin_px};
      places.push_back(std::move(place));
    }
  }
  return places;
}

std::vector<Place> find_cell_grids(ImageView picture, const std::set<Frame>& frames) {
  const std::optional<TwoLevels> levels = TwoLevels::of(picture);
  if (!levels) return {};
  std::set<int> sides;
  for (const Frame& frame : frames) sides.insert(frame.cells_at_border());
  std::vector<Place> places;
  for (const int cells : sides) {
    for (int cell_px = 1; cell_px <= kLargestGridCell_px; ++cell_px) {
      const int side_px = cells * cell_px;
      for (int top = 0; top + side_px <= levels->height(); ++top) {
        for (int left = 0; left + side_px <= levels->width(); ++left) {
          if (!has_border(*levels, {left, top, cell_px, cells})) continue;
          places.push_back({upright_square(left, top, side_px, side_px), cells});
        }
      }
    }
  }
  return places;
}

std::vector<Place> filled_places(ImageView picture, const std::map<Frame, int>& rings_of_frames) {
  std::vector<Place> places;
  for (const Part& part : parts_of(picture)) {
    if (!nearly_square(part)) continue;
    for (const auto& [frame, rings] : rings_of_frames) {
      for (int cut = 0; cut <= rings; ++cut) {
        const int seen = frame.width - 2 * cut;  // cells across the part
        const double cell_x = static_cast<double>(part.width) / seen;
        const double cell_y = static_cast<double>(part.height) / seen;
        const int first = frame.border_offset - cut;
        const int cells = frame.cells_at_border();
        places.push_back({upright_square(part.left + first * cell_x, part.top + first * cell_y,
                                         cells * cell_x, cells * cell_y),
                          cells});
      }
    }
  }
  return places;
}

}  // namespace tagmint::identify
