#pragma once

#include <optional>

#include "tagmint/codec/export.h"
#include "tagmint/detect/camera.h"

namespace tagmint::detect {

/// The ways from pixels to quads (docs/detector.md); what follows is the same for both.
enum class Algorithm {
  Tracker,  ///< follows shapes in a bitmap: many times faster
  Paper     ///< components, boundary clusters and line fits of AprilTag 2 [WangOlson2016]
};

/// Settings of a Detector, by stage. Defaults suit a noisy camera; figures without a source are the
/// reference detector's documented ones.
struct TAGMINT_API DetectorOptions {
  Algorithm algorithm = Algorithm::Tracker;

  // Stage 1, preprocessing.
  double decimate = 1.0;  ///< >= 1; quads are looked for in an image this many times smaller
  double blur_sigma_px =
      0.0;  ///< Gaussian blur of the working image; negative = sharpen by as much; -100..100

  // Stage 2, threshold.
  int min_contrast = 5;  ///< gray levels; flatter 3x3 tile neighbourhoods are left out, 0..255
  /// Raise that with the noise that the picture shows, so that noise alone stays below it.
  bool contrast_by_noise = true;

  // Stage 4, clusters.
  int min_cluster_points = 24;  ///< fewer boundary points are no tag

  // Stage 5, quads.
  int max_corner_candidates = 10;      ///< peaks of the line-fit error kept for the search, 4..32
  double max_line_fit_mse_px2 = 10.0;  ///< mean squared distance of a side's points from its line
  double critical_angle_deg = 10.0;    ///< corners nearer to 0 or 180 degrees are refused
  double min_side_px = 4.0;  ///< full-resolution pixels; quads with a smaller mean side are refused

  // Stage 6, edges.
  bool refine_edges = true;  ///< fit the quad's edges again to the full-resolution gradient

  // Stage 7, decoding.
  double decode_sharpening =
      0.25;  ///< weight of the 4-neighbour Laplacian on the sampled cells; 0 = off
  double min_decision_margin = 0;  ///< detections below are dropped
  double min_log_odds = 0;         ///< detections with Detection::log_odds below are dropped
  bool read_harder = true;         ///< read quads without a codeword again, for shadow and blur
  bool report_inverted = false;    ///< find tags printed with black for white, and say so
  bool report_mirrored = false;    ///< find tags printed left for right, and say so

  // After stage 8, tags.
  /// Find the corners of each tag again from all edges that its word draws, with their covariance.
  bool refine_photometric = true;
  /// The camera, where its lens distorts: the photometric step then follows sides that are curved
  /// in the picture. Detections stay in the picture's own pixels.
  std::optional<Camera> lens = {};

  int threads = 1;  ///< that share the quad fits and decodes of one image; 0 = all cores. The
                    ///< result stays the same.
};

}  // namespace tagmint::detect
