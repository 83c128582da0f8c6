#include "decode_quads.h"

#include <algorithm>
#include <utility>

#include "stage_timer.h"

namespace tagmint::detect {
namespace {

void count(DecodeOutcome outcome, DetectStats& stats) {
  switch (outcome) {
    case DecodeOutcome::OutsideImage:
      ++stats.outside_image;
      break;
    case DecodeOutcome::NoContrast:
      ++stats.no_contrast;
      break;
    case DecodeOutcome::NoCodeword:
      ++stats.no_codeword;
      break;
    case DecodeOutcome::LowMargin:
      ++stats.low_margin;
      break;
    case DecodeOutcome::Decoded:
      break;
  }
}

}  // namespace

QuadDecoding::QuadDecoding(Decoders decoders, const DetectorOptions& o)
    : decoders_(std::move(decoders)),
      inverted_(o.report_inverted),
      options_{.sharpening = o.decode_sharpening,
               .min_decision_margin = o.min_decision_margin,
               .min_log_odds = o.min_log_odds,
               .harder = o.read_harder,
               .mirrored = o.report_mirrored} {}

/// One quad with all families that may be in it; how far it came with any of them.
DecodeOutcome QuadDecoding::read(const Quad& quad, const DecodeOptions& options,
                                 DecodeScratch& scratch,
                                 std::span<std::optional<Detection>> found) {
  DecodeOutcome farthest = DecodeOutcome::OutsideImage;
  for (std::size_t i = 0; i < decoders_.size(); ++i) {
    const bool reversed = decoders_[i]->family()->layout().reversed_border();
    if (reversed != quad.reversed_border && !inverted_) continue;
    DecodeResult result = decode_family(*decoders_[i], options, scratch);
    farthest = std::max(farthest, result.outcome);
    found[i] = std::move(result.detection);
  }
  return farthest;
}

/// Read harder only where no family has a word near: what is a tag of one would cost all others
/// their hardest reading. Counted once.
void QuadDecoding::decode_one(ImageView full, const Quad& quad, Worker& worker,
                              std::span<std::optional<Detection>> found) {
  start_quad(full, quad, worker.decode);
  DecodeOptions plain = options_;
  plain.harder = false;
  DecodeOutcome farthest = read(quad, plain, worker.decode, found);
  if (options_.harder && farthest == DecodeOutcome::NoCodeword) {
    farthest = read(quad, options_, worker.decode, found);
  }
  count(farthest, worker.stats);
}

void QuadDecoding::decode(ImageView full, std::span<const Quad> quads, WorkShare& share,
                          DetectStats& stats, std::vector<Detection>& candidates) {
  const StageTimer timer(stats, Stage::Decode);
  const std::size_t each = decoders_.size();
  found_.assign(quads.size() * each, std::nullopt);
  share.for_each_index(quads.size(), workers_, [&](std::size_t i, Worker& worker) {
    decode_one(full, quads[i], worker, std::span(found_).subspan(i * each, each));
  });
  collect_stats(workers_, stats);
  candidates.clear();
  for (std::optional<Detection>& read : found_) {
    if (read) candidates.push_back(std::move(*read));
  }
}

}  // namespace tagmint::detect
