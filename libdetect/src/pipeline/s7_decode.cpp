#include "pipeline/s7_decode.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "decode/cell_evidence.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::detect {
namespace {

using codec::Layout;

/// Gray levels: the rings of a tag without noise differ by rounding at least.
constexpr double kLeastNoise = 0.5;

/// A word that was recognised, and how it was read.
struct Recognised {
  codec::Match match;
  Reading reading;
  Print print;
  const Whiteness* cells = nullptr;  ///< that it was read from; in the scratch
  int tries = 0;                     ///< readings that were looked up until then
};

/// The rings that the current quad shows for a geometry, read when first asked for.
const CellGrid& grid_of(const GridGeometry& geometry, DecodeScratch& scratch) {
  for (std::size_t i = 0; i < scratch.grids_in_use; ++i) {
    if (scratch.grids[i].geometry() == geometry) return scratch.grids[i];
  }
  if (scratch.grids_in_use == scratch.grids.size()) scratch.grids.emplace_back();
  CellGrid& grid = scratch.grids[scratch.grids_in_use++];
  const double side_px = std::sqrt(std::abs(signed_area(scratch.quad.corners)));
  grid.read(scratch.full, *scratch.tag_to_image, side_px, geometry, scratch.quad.reversed_border);
  return grid;
}

/// Looks readings of one quad up, the plainest first.
class Reader {
 public:
  Reader(const codec::Decoder& decoder, const CellGrid& grid, const DecodeOptions& options,
         DecodeScratch& scratch)
      : decoder_(decoder),
        layout_(decoder.family()->layout()),
        grid_(grid),
        options_(options),
        scratch_(scratch) {
    print_.inverted = layout_.reversed_border() != scratch.quad.reversed_border;
  }

  std::optional<Recognised> recognise() {
    if (const auto found = either_way(scratch_.read, options_.sharpening)) return found;
    if (!options_.harder) return std::nullopt;
    if (whiteness_in_shadow(grid_, layout_, scratch_.sorted, scratch_.harder)) {
      if (const auto found = either_way(scratch_.harder, options_.sharpening)) return found;
    }
    for (const double share : kBlurShares) {
      deconvolve(grid_, scratch_.read, share, scratch_.deconvolve, scratch_.harder);
      if (const auto found = either_way(scratch_.harder, 0)) return found;
    }
    return std::nullopt;
  }

 private:
  /// As printed, and mirrored where that is asked for.
  std::optional<Recognised> either_way(const Whiteness& cells, double sharpening) {
    print_.mirrored = false;
    std::optional<Recognised> found = look_up(cells, sharpening);
    if (!found && options_.mirrored) {
      print_.mirrored = true;
      found = look_up(cells, sharpening);
      print_.mirrored = false;
    }
    return found;
  }

  std::optional<Recognised> look_up(const Whiteness& cells, double sharpening) {
    ++tries_;
    const Reading reading = read_word(layout_, cells, sharpening, print_);
    const std::optional<codec::Match> match = decoder_.decode(reading.word);
    if (!match) return std::nullopt;
    return Recognised{*match, reading, print_, &cells, tries_};
  }

  const codec::Decoder& decoder_;
  const Layout& layout_;
  const CellGrid& grid_;
  const DecodeOptions& options_;
  DecodeScratch& scratch_;
  Print print_;
  int tries_ = 0;
};

/// Corners and homography of the upright tag. Match::rotation counter-clockwise turns make the
/// picture upright, so upright places come from places turned clockwise in the quad's own frame. Of
/// a mirrored print the corners go the other way round.
void place(const Recognised& found, const Corners& quad, const Homography& tag_to_image,
           Detection& detection) {
  Corners corners = quad;
  Homography map = tag_to_image;
  if (found.print.mirrored) {
    corners = {quad[1], quad[0], quad[3], quad[2]};
    const auto& h = tag_to_image.row_major();
    map = Homography({-h[0], h[1], h[2], -h[3], h[4], h[5], -h[6], h[7], h[8]});
  }
  detection.homography = map.rotated(found.match.rotation);
  for (int i = 0; i < 4; ++i) detection.corners[i] = corners[(i + 3 * found.match.rotation) % 4];
  detection.center = detection.homography.project({0, 0});
}

Detection make_detection(const codec::Decoder& decoder, const Recognised& found,
                         const CellGrid& grid, DecodeScratch& scratch) {
  Detection detection;
  detection.family = decoder.family();
  detection.id = found.match.id;
  detection.hamming = found.match.hamming;
  detection.inverted = found.print.inverted;
  detection.mirrored = found.print.mirrored;
  detection.decision_margin = found.reading.decision_margin;
  place(found, scratch.quad.corners, *scratch.tag_to_image, detection);
  // The codeword as the quad shows it, turned back.
  const codec::Codeword seen = codec::rotate(decoder.family()->codeword(found.match.id),
                                             decoder.family()->bits(), 4 - found.match.rotation);
  const double evidence = cell_evidence(decoder.family()->layout(), *found.cells, seen, found.print,
                                        2 * grid.ring_scatter() / grid.contrast(), scratch.colours);
  detection.log_odds = log_odds(*decoder.family(), found.match.hamming, evidence, found.tries);
  detection.margin_to_noise =
      detection.decision_margin / std::max(kLeastNoise, grid.ring_scatter());
  return detection;
}

}  // namespace

void start_quad(ImageView full, const Quad& quad, DecodeScratch& scratch) {
  scratch.full = full;
  scratch.quad = quad;
  scratch.tag_to_image = Homography::from_corners(quad.corners);
  scratch.grids_in_use = 0;
}

DecodeResult decode_family(const codec::Decoder& decoder, const DecodeOptions& options,
                           DecodeScratch& scratch) {
  if (!scratch.tag_to_image) return {DecodeOutcome::OutsideImage, {}};
  const Layout& layout = decoder.family()->layout();
  const CellGrid& grid = grid_of(GridGeometry::of(layout), scratch);
  if (grid.outcome() == BorderOutcome::OutsideImage) return {DecodeOutcome::OutsideImage, {}};
  if (grid.outcome() == BorderOutcome::NoContrast) return {DecodeOutcome::NoContrast, {}};
  if (!whiteness_by_planes(grid, layout, scratch.read)) return {DecodeOutcome::OutsideImage, {}};
  const std::optional<Recognised> found = Reader(decoder, grid, options, scratch).recognise();
  if (!found) return {DecodeOutcome::NoCodeword, {}};
  Detection detection = make_detection(decoder, *found, grid, scratch);
  if (detection.decision_margin < options.min_decision_margin ||
      detection.log_odds < options.min_log_odds) {
    return {DecodeOutcome::LowMargin, {}};
  }
  return {DecodeOutcome::Decoded, std::move(detection)};
}

DecodeResult decode_quad(ImageView full, const Quad& quad, const codec::Decoder& decoder,
                         const DecodeOptions& options, DecodeScratch& scratch) {
  start_quad(full, quad, scratch);
  return decode_family(decoder, options, scratch);
}

}  // namespace tagmint::detect
