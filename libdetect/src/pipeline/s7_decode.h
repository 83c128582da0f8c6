#pragma once

#include <optional>
#include <vector>

#include "decode/cell_grid.h"
#include "decode/deconvolve.h"
#include "decode/read_word.h"
#include "pipeline/stage_types.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/detect/detection.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Stage 7: a quad and a family -> the tag in it, if there is one.
struct DecodeOptions {
  double sharpening = 0.25;        ///< weight of the 4-neighbour Laplacian on the cells; 0 = off
  double min_decision_margin = 0;  ///< gray levels
  double min_log_odds = 0;         ///< Detection::log_odds
  bool harder = true;              ///< read again in shadow and through blur where need be
  bool mirrored = false;           ///< look for mirrored prints too
};

/// How far a candidate came, worst first.
enum class DecodeOutcome {
  OutsideImage,  ///< a data cell, or too much of the border, is not in the picture
  NoContrast,    ///< black ring not clearly darker than the white ring
  NoCodeword,    ///< too many bits differ from every codeword
  LowMargin,     ///< below min_decision_margin or min_log_odds
  Decoded
};

struct DecodeResult {
  DecodeOutcome outcome = DecodeOutcome::OutsideImage;
  std::optional<Detection> detection;  ///< when Decoded
};

/// Buffers that decoding keeps from one candidate to the next, and what it has read of the current
/// one; one for each thread.
struct DecodeScratch {
  ImageView full;
  Quad quad;
  std::optional<Homography> tag_to_image;
  std::vector<CellGrid> grids;   ///< one for each geometry that the quad was read for
  std::size_t grids_in_use = 0;  ///< of the current quad; the others keep their memory
  Whiteness read, harder;
  DeconvolveScratch deconvolve;
  std::vector<std::int8_t> colours;
  std::vector<double> sorted;
};

/// Makes `quad` the one that decode_family() reads.
///   full   full-resolution image
///   quad   convex, counter-clockwise as seen, full-resolution px
void start_quad(ImageView full, const Quad& quad, DecodeScratch& scratch);

/// Reads the cells of the tag whose border square the started quad may be. The rings inside and
/// outside of the border square give the gray level of black and of white at each place; half-way
/// between is the threshold of a cell. Where no codeword is near, once more against one threshold
/// that a shadow across the tag does not upset, and with blur taken out.
///
/// A quad with the other kind of border than the family's may be an inverted print.
///   decoder   its layout's geometry is sampled once a quad, whatever the number of families
///   cost      some gray values a cell, then Decoder::decode()
DecodeResult decode_family(const codec::Decoder& decoder, const DecodeOptions& options,
                           DecodeScratch& scratch);

/// Both for one family.
DecodeResult decode_quad(ImageView full, const Quad& quad, const codec::Decoder& decoder,
                         const DecodeOptions& options, DecodeScratch& scratch);

}  // namespace tagmint::detect
