#include "tagmint/detect/detector.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>

#include "check_options.h"
#include "decode_quads.h"
#include "paper_path.h"
#include "pipeline/s8_reconcile.h"
#include "quad_kinds.h"
#include "stage_timer.h"
#include "tag_refinement.h"
#include "tracker_path.h"
#include "work_share.h"

namespace tagmint::detect {
namespace {

QuadKinds kinds_of(const Decoders& decoders, const DetectorOptions& options) {
  QuadKinds kinds;
  for (const auto& decoder : decoders) kinds.add(decoder->family()->layout());
  if (options.report_inverted) kinds.normal_borders = kinds.reversed_borders = true;
  return kinds;
}

void check_image(ImageView image) {
  if (image.empty()) return;
  if (image.data == nullptr) {
    throw std::invalid_argument(fmt::format("an image of {} x {} pixels without data cannot be",
                                            image.width, image.height));
  }
  if (image.width > Detector::kMaxSide_px || image.height > Detector::kMaxSide_px) {
    throw std::invalid_argument(
        fmt::format("an image of {} x {} pixels is too large; its sides may be at most {} pixels",
                    image.width, image.height, Detector::kMaxSide_px));
  }
}

}  // namespace

/// One of the two paths finds the quads; what follows is the same for both.
struct Detector::Impl {
  DetectorOptions options;
  WorkShare share;
  std::variant<PaperPath, TrackerPath> path;
  QuadDecoding decoding;
  TagRefinement refinement;

  Impl(Decoders decoders, const DetectorOptions& o)
      : options(o),
        share(o.threads),
        path(std::in_place_type<PaperPath>, o, kinds_of(decoders, o)),
        decoding(std::move(decoders), o),
        refinement(o) {
    if (o.algorithm == Algorithm::Tracker) {
      path.emplace<TrackerPath>(o, kinds_of(decoding.decoders(), o));
    }
  }

  void detect(ImageView full, std::vector<Detection>& detections, DetectStats& stats,
              DebugSink* debug) {
    const std::span<const Quad> quads = std::visit(
        [&](auto& finder) { return finder.find_quads(full, share, stats, debug); }, path);
    decoding.decode(full, quads, share, stats, detections);
    {
      const StageTimer timer(stats, Stage::Reconcile);
      reconcile(detections, stats);
    }
    if (options.refine_photometric) {
      refinement.refine(full, detections, share, stats);
      sort_detections(detections);
    }
    if (debug) debug->detections(detections);
  }
};

Detector::Detector(Decoders decoders, DetectorOptions options) {
  if (decoders.empty()) {
    throw std::invalid_argument("a detector needs at least one decoder; there is none");
  }
  if (std::find(decoders.begin(), decoders.end(), nullptr) != decoders.end()) {
    throw std::invalid_argument("a detector's decoder is null; each must be a Decoder");
  }
  check_options(options);
  impl_ = std::make_unique<Impl>(std::move(decoders), options);
}

Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

std::vector<Detection> Detector::detect(ImageView image, DetectStats* stats, DebugSink* debug) {
  std::vector<Detection> detections;
  detect(image, detections, stats, debug);
  return detections;
}

void Detector::detect(ImageView image, std::vector<Detection>& detections, DetectStats* stats,
                      DebugSink* debug) {
  check_image(image);
  DetectStats counted;
  detections.clear();
  if (!image.empty()) impl_->detect(image, detections, counted, debug);
  if (stats) *stats = counted;
}

const DetectorOptions& Detector::options() const { return impl_->options; }

}  // namespace tagmint::detect
