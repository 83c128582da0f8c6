#pragma once

#include <vector>

#include "support/fixed_random.h"
#include "tagmint/codec/family.h"
#include "tagmint/detect/geometry.h"
#include "tagmint/detect/homography.h"
#include "tagmint/detect/image.h"

namespace tagmint::testing {

/// A picture before it is quantised: gray levels as floats, row-major.
struct Canvas {
  int width = 0;
  int height = 0;
  std::vector<float> gray;

  Canvas(int w, int h, float value)
      : width(w), height(h), gray(static_cast<std::size_t>(w) * h, value) {}
  float& at(int x, int y) { return gray[static_cast<std::size_t>(y) * width + x]; }
  float at(int x, int y) const { return gray[static_cast<std::size_t>(y) * width + x]; }
};

/// Gray levels of a printed tag.
struct Ink {
  double black = 40;
  double white = 210;
  int quiet_cells = 1;  ///< cells of `white` around the whole tag
};

/// Paints the cells of one tag through `tag_to_image`, which maps the border square [-1,1]^2 to
/// pixels. Each pixel is the mean over 64 points of the Hammersley set, so that an edge of any
/// direction is right to about a hundredth of a pixel. Cells that are none stay as they were.
void paint_tag(Canvas& canvas, const codec::Family& family, codec::TagId id,
               const detect::Homography& tag_to_image, const Ink& ink = {});

/// Gaussian blur, separable, cut off at 4 sigma; the border pixels go on outside.
void blur(Canvas& canvas, double sigma_px);

/// Rounds to 8 bits after adding normal noise.
detect::Image to_gray(const Canvas& canvas, double noise_sigma, FixedRandom& random);

/// A square of side `side_px` around `centre`, turned clockwise as seen by `angle_rad`.
detect::Homography square_at(detect::Point centre, double side_px, double angle_rad = 0);

/// The same square leaning back: `tilt_rad` about an axis in the image plane whose direction is
/// `axis_rad`, seen by a camera `distance_sides` sides of the square away.
detect::Homography tilted_square_at(detect::Point centre, double side_px, double angle_rad,
                                    double tilt_rad, double axis_rad, double distance_sides = 10);

/// Where the border square's corners are, in the order of kTagCorners.
detect::Corners corners_of(const detect::Homography& tag_to_image);

/// A family of at most `codes` random words, at least `min_hamming` apart in all rotations.
codec::SharedFamily random_family(const std::string& name, const codec::Layout& layout,
                                  int min_hamming, int codes, std::uint64_t seed = 1);

}  // namespace tagmint::testing
