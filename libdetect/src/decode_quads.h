#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/s7_decode.h"
#include "pipeline/stage_types.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/detect/detect_stats.h"
#include "tagmint/detect/detection.h"
#include "tagmint/detect/detector_options.h"
#include "tagmint/detect/image_view.h"
#include "work_share.h"

namespace tagmint::detect {

using Decoders = std::vector<std::shared_ptr<const codec::Decoder>>;

/// Stage 7 for all quads of an image and all families, whichever path found the quads.
class QuadDecoding {
 public:
  QuadDecoding(Decoders decoders, const DetectorOptions& options);

  const Decoders& decoders() const { return decoders_; }

  /// Each quad against each family with its kind of border.
  ///   candidates   get what was read, in the order of quads, then of decoders
  ///   stats        how far each quad came, and the time, are added
  void decode(ImageView full, std::span<const Quad> quads, WorkShare& share, DetectStats& stats,
              std::vector<Detection>& candidates);

 private:
  /// What a thread needs for its share of the quads.
  struct Worker {
    DecodeScratch decode;
    DetectStats stats;
  };

  DecodeOutcome read(const Quad& quad, const DecodeOptions& options, DecodeScratch& scratch,
                     std::span<std::optional<Detection>> found);
  void decode_one(ImageView full, const Quad& quad, Worker& worker,
                  std::span<std::optional<Detection>> found);

  Decoders decoders_;
  bool inverted_;  ///< whether quads with the other kind of border are read too
  DecodeOptions options_;
  std::vector<std::optional<Detection>> found_;  ///< by quad, then decoder
  tbb::enumerable_thread_specific<Worker> workers_;
};

}  // namespace tagmint::detect
