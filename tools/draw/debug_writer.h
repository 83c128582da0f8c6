#pragma once

#include <filesystem>

#include "tagmint/detect/debug_sink.h"
#include "tagmint/detect/image.h"

namespace tagmint::draw {

/// Writes the intermediate pictures of one detection as numbered PNG files: 1-preprocessed,
/// 2-threshold (black, white, gray = too little contrast), 3-components (a colour each, black = too
/// little contrast), 4-clusters (boundary points at twice the working size, a colour a cluster),
/// 5-quads, 6-refined-quads, 7-detections (over the dimmed image). The tracker has no components;
/// its clusters are the outlines of shapes.
class DebugWriter : public detect::DebugSink {
 public:
  /// Creates `folder` where it is missing; throws codec::OutputError when that fails. Every member
  /// throws codec::OutputError when its picture cannot be written.
  ///   image    the full-resolution image; what it points to must outlive the writer
  DebugWriter(std::filesystem::path folder, detect::ImageView image);

  void preprocessed(detect::ImageView working) override;
  void threshold(detect::ImageView three_valued) override;
  void components(std::span<const std::uint32_t> labels, int width, int height) override;
  void clusters(std::span<const detect::Point> points,
                std::span<const std::size_t> cluster_begin) override;
  void quads(std::span<const detect::Corners> quads) override;
  void refined_quads(std::span<const detect::Corners> quads) override;
  void detections(std::span<const detect::Detection> detections) override;

 private:
  void write_quads(std::string_view file, std::span<const detect::Corners> quads) const;

  std::filesystem::path folder_;
  detect::ImageView image_;
  detect::Image working_;  // a copy, behind the clusters
};

}  // namespace tagmint::draw
