#include "pipeline/s7_decode.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "numerics/gray_model.h"

namespace tagmint::detect {
namespace {

using codec::Cell;
using codec::CellPosition;
using codec::Layout;

/// Share of a ring's cells that must be in the image for its plane to be trusted over the tag.
constexpr double kMinRingShare = 0.5;
/// Rings whose cells scatter about their planes by more than this share of the contrast between the
/// planes are no border: with half the contrast from either plane to the threshold, one cell in
/// thirteen would then be taken for the other colour. Rings of rendered tags have 0.001 to 0.08, of
/// 291 tags in photographs up to 0.23, of quads fitted to noise 0.31 and more (docs/pipeline.md).
constexpr double kMaxRingScatter = 0.35;
/// What the cells of one ring say: their plane, and how far they are from it.
struct Ring {
  GrayPlane plane;
  int cells = 0;
  double squared_residuals = 0;
};

/// The ring `ring` cells from the tag's outer edge; nothing when too little of it is in the image.
std::optional<Ring> read_ring(const CellGrid& cells, const Layout& layout, int ring) {
  const int last = layout.width() - 1 - ring;
  GrayModel model;
  const auto add = [&](CellPosition p) {
    if (cells.known(p)) model.add(cells.centre(p), cells.gray(p));
  };
  if (ring == last) {  // a single cell in the middle of the tag has no slope
    if (!cells.known({ring, ring})) return std::nullopt;
    return Ring{{0, 0, cells.gray({ring, ring})}, 1, 0};
  }
  for (int i = ring; i < last; ++i) {
    add({i, ring});
    add({last, i});
    add({last - i + ring, last});
    add({ring, last - i + ring});
  }
  if (model.samples() < kMinRingShare * 4 * (last - ring)) return std::nullopt;
  const std::optional<GrayPlane> plane = model.fit();
  if (!plane) return std::nullopt;
  return Ring{*plane, model.samples(), model.squared_residuals(*plane)};
}

/// Gray level of black and of white over the tag.
struct TwoColours {
  GrayPlane black;
  GrayPlane white;
  double ring_scatter = 0;  ///< rms distance of the rings' cells from their planes

  double threshold(Point p) const { return (black.at(p) + white.at(p)) / 2; }
  double contrast(Point p) const { return white.at(p) - black.at(p); }
  /// Whether the rings are those of a border: one darker than the other, and both even.
  bool tell_a_border() const {
    const double contrast_in_the_middle = contrast({0, 0});
    return contrast_in_the_middle > 0 && ring_scatter <= kMaxRingScatter * contrast_in_the_middle;
  }
};

std::optional<TwoColours> fit_colours(const CellGrid& cells, const Layout& layout) {
  const auto outside = read_ring(cells, layout, layout.border_offset() - 1);
  const auto inside = read_ring(cells, layout, layout.border_offset());
  if (!outside || !inside) return std::nullopt;
  const double scatter = std::sqrt((outside->squared_residuals + inside->squared_residuals) /
                                   (outside->cells + inside->cells));
  if (layout.reversed_border()) return TwoColours{outside->plane, inside->plane, scatter};
  return TwoColours{inside->plane, outside->plane, scatter};
}

/// Sets scratch.excess and scratch.known; false when a data cell is outside the image.
bool compare_cells(const Layout& layout, const TwoColours& colours, DecodeScratch& scratch) {
  const int width = layout.width();
  const auto cells = static_cast<std::size_t>(width) * static_cast<std::size_t>(width);
  scratch.excess.assign(cells, 0.0f);
  scratch.known.assign(cells, 0);
  std::size_t i = 0;
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x, ++i) {
      const Cell cell = layout.cell(x, y);
      if (cell == Cell::None) continue;
      const CellPosition p = {x, y};
      if (scratch.cells.known(p)) {
        scratch.excess[i] =
            static_cast<float>(scratch.cells.gray(p) - colours.threshold(scratch.cells.centre(p)));
        scratch.known[i] = 1;
      } else if (cell == Cell::Data) {
        return false;
      }
    }
  }
  return true;
}

/// The cell's excess, raised against the mean of its neighbours to undo blur across the cell's
/// edges: v + weight * sum over known neighbours (v - neighbour).
double sharpened(const DecodeScratch& scratch, int width, CellPosition p, double weight) {
  const auto at = static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(p.x);
  const double value = scratch.excess[at];
  double laplacian = 0;
  const auto take = [&](bool inside, std::size_t i) {
    if (inside && scratch.known[i]) laplacian += value - static_cast<double>(scratch.excess[i]);
  };
  take(p.x + 1 < width, at + 1);
  take(p.y + 1 < width, at + static_cast<std::size_t>(width));
  take(p.x > 0, at - 1);
  take(p.y > 0, at - static_cast<std::size_t>(width));
  return value + weight * laplacian;
}

/// The word on the cells and how clearly it was read.
struct Reading {
  codec::Codeword word = 0;
  double decision_margin = 0;
};

Reading read_word(const Layout& layout, double sharpening, const DecodeScratch& scratch) {
  Reading reading;
  double white_sum = 0, black_sum = 0;
  int whites = 0, blacks = 0;
  for (const CellPosition p : layout.data_cells()) {
    const double value = sharpened(scratch, layout.width(), p, sharpening);
    const bool white = value > 0;
    reading.word = (reading.word << 1) | static_cast<codec::Codeword>(white);
    (white ? white_sum : black_sum) += std::abs(value);
    ++(white ? whites : blacks);
  }
  // A colour that does not occur cannot be unclear.
  const double white_mean = whites > 0 ? white_sum / whites : black_sum / blacks;
  const double black_mean = blacks > 0 ? black_sum / blacks : white_mean;
  reading.decision_margin = std::min(white_mean, black_mean);
  return reading;
}

/// Corners and homography of the upright tag. Match::rotation counter-clockwise turns make the
/// picture upright, so upright places come from places turned clockwise in the quad's own frame.
Detection make_detection(const codec::Decoder& decoder, const codec::Match& match, const Quad& quad,
                         const Homography& tag_to_image, double decision_margin) {
  Detection detection;
  detection.family = decoder.family();
  detection.id = match.id;
  detection.hamming = match.hamming;
  detection.decision_margin = decision_margin;
  detection.homography = tag_to_image.rotated(match.rotation);
  for (int i = 0; i < 4; ++i) detection.corners[i] = quad.corners[(i + 3 * match.rotation) % 4];
  detection.center = detection.homography.project({0, 0});
  return detection;
}

}  // namespace

DecodeResult decode_quad(ImageView full, const Quad& quad, const codec::Decoder& decoder,
                         const DecodeOptions& options, DecodeScratch& scratch) {
  const Layout& layout = decoder.family()->layout();
  assert(layout.reversed_border() == quad.reversed_border);
  const std::optional<Homography> tag_to_image = Homography::from_corners(quad.corners);
  if (!tag_to_image) return {DecodeOutcome::OutsideImage, {}};
  const double side_px = std::sqrt(std::abs(signed_area(quad.corners)));
  scratch.cells.read(full, *tag_to_image, layout, side_px);
  const std::optional<TwoColours> colours = fit_colours(scratch.cells, layout);
  if (!colours) return {DecodeOutcome::OutsideImage, {}};
  if (!colours->tell_a_border()) return {DecodeOutcome::NoContrast, {}};
  if (!compare_cells(layout, *colours, scratch)) return {DecodeOutcome::OutsideImage, {}};
  const Reading reading = read_word(layout, options.sharpening, scratch);
  const std::optional<codec::Match> match = decoder.decode(reading.word);
  if (!match) return {DecodeOutcome::NoCodeword, {}};
  if (reading.decision_margin < options.min_decision_margin) return {DecodeOutcome::LowMargin, {}};
  return {DecodeOutcome::Decoded,
          make_detection(decoder, *match, quad, *tag_to_image, reading.decision_margin)};
}

}  // namespace tagmint::detect
