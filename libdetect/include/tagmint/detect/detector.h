#pragma once

#include <memory>
#include <vector>

#include "tagmint/codec/decoder.h"
#include "tagmint/codec/export.h"
#include "tagmint/detect/debug_sink.h"
#include "tagmint/detect/detect_stats.h"
#include "tagmint/detect/detection.h"
#include "tagmint/detect/detector_options.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Finds tags of any layouts, several families at once: by the tracker, or by the pipeline of
/// AprilTag 2 [WangOlson2016] (DetectorOptions::algorithm).
///
/// Owns its scratch memory, so one Detector serves one caller at a time; use one for each thread.
/// Decoders (and through them families) are constant and may be shared by any number of detectors.
class TAGMINT_API Detector {
 public:
  /// `decoders`: one for each family to look for; the correction radius and the ids in use are
  /// theirs. Throws std::invalid_argument when there is none, one is null, or an option is out of
  /// range (the text names it).
  explicit Detector(std::vector<std::shared_ptr<const codec::Decoder>> decoders,
                    DetectorOptions options = {});
  ~Detector();
  Detector(Detector&&) noexcept;
  Detector& operator=(Detector&&) noexcept;

  /// Finds all tags in `image`, sorted by family name, id, then centre (y, x). Any size up to
  /// kMaxSide_px works; an image smaller than a few tiles has no tags. Throws std::invalid_argument
  /// for a larger one, and for one without data. Depends on the image and the options alone, never
  /// on threads.
  ///   stats   if given, counts and times of this image are written to it
  ///   debug   if given, takes the intermediate pictures
  std::vector<Detection> detect(ImageView image, DetectStats* stats = nullptr,
                                DebugSink* debug = nullptr);

  /// The same into `detections`, which keeps its memory. With one thread and Algorithm::Tracker a
  /// frame takes no memory, once the detector has seen one as large and as rich.
  void detect(ImageView image, std::vector<Detection>& detections, DetectStats* stats = nullptr,
              DebugSink* debug = nullptr);

  /// Largest width and height of an image, px; larger ones are refused.
  static constexpr int kMaxSide_px = 1 << 15;

  const DetectorOptions& options() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tagmint::detect
