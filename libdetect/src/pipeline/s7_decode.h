#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/cell_grid.h"
#include "pipeline/stage_types.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/detect/detection.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Stage 7: a quad and a family -> the tag in it, if there is one.
struct DecodeOptions {
  double sharpening = 0.25;        ///< weight of the 4-neighbour Laplacian on the cells; 0 = off
  double min_decision_margin = 0;  ///< gray levels
};

/// How far a candidate came, worst first.
enum class DecodeOutcome {
  OutsideImage,  ///< a data cell, or too much of the border, is not in the picture
  NoContrast,    ///< black ring not clearly darker than the white ring
  NoCodeword,    ///< too many bits differ from every codeword
  LowMargin,     ///< below min_decision_margin
  Decoded
};

struct DecodeResult {
  DecodeOutcome outcome = DecodeOutcome::OutsideImage;
  std::optional<Detection> detection;  ///< when Decoded
};

/// Buffers that decode_quad() keeps from one candidate to the next; one for each thread.
struct DecodeScratch {
  CellGrid cells;
  /// By cell of the whole tag, row-major: gray value less the threshold there...
  std::vector<float> excess;
  /// ...where this is not 0; not for cells that are not printed or lie outside the image.
  std::vector<std::uint8_t> known;
};

/// Reads the cells of the tag whose border square `quad` may be. The rings inside and outside of
/// the border square give the gray level of black and of white at each place; half-way between is
/// the threshold of a cell.
///   full      full-resolution image
///   quad      convex, counter-clockwise as seen, full-resolution px
///   decoder   of a family whose layout has the quad's kind of border
///   cost      some gray values a cell, then Decoder::decode()
DecodeResult decode_quad(ImageView full, const Quad& quad, const codec::Decoder& decoder,
                         const DecodeOptions& options, DecodeScratch& scratch);

}  // namespace tagmint::detect
