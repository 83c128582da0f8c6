#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Gray values along the normal of an edge, half a pixel apart, farther for a wide search.
struct NormalProfile {
  /// Steps from the foot to either end of the search, at most.
  static constexpr int kMaxReach = 16;
  /// Values on either side of the place where a change is taken.
  static constexpr int kHalfChange = 1;

  std::array<float, 2 * (kMaxReach + kHalfChange) + 1> gray;
  float step = 0.5f;  ///< px between neighbouring values
  int reach = 0;      ///< steps from the foot to either end of the search
  int steepest = 0;   ///< change(steepest) is the largest
  float darkest = 0;  ///< of all values
  float brightest = 0;

  int changes() const { return 2 * reach + 1; }
  /// Difference over the two steps around place_of(i), 0 <= i < changes(). Over a pixel it neither
  /// doubles the noise nor blurs a sharp edge much.
  float change(int i) const {
    return gray[static_cast<std::size_t>(i + 2 * kHalfChange)] - gray[static_cast<std::size_t>(i)];
  }
  /// Place of change i from the foot, px; fractions lie between.
  float place_of(float i) const { return (i - static_cast<float>(reach)) * step; }
};

/// Reads profiles across one straight edge.
class ProfileReader {
 public:
  ///   outward   unit vector
  ///   search    px to either side of a foot
  ///   rising    whether gray values shall rise outwards; else their negatives are read
  ProfileReader(ImageView image, Point outward, double search, bool rising);

  /// The values about `foot`, bilinearly; false when the profile leaves the image or changes by
  /// less than two gray levels.
  ///   cost      four pixels a value
  bool read(Point foot, NormalProfile& profile) const;

 private:
  ImageView image_;
  float step_px_;
  int reach_;
  int values_;
  Point to_start_;  ///< from the foot
  Point to_end_;
  float scale_;
  std::uint32_t last_x_, last_y_, step_x_, step_y_;  ///< see kPlaceBits in the source
};

/// One profile; nothing where ProfileReader::read() is false.
std::optional<NormalProfile> read_profile(ImageView image, Point foot, Point outward, double search,
                                          bool rising);

/// Mean place of the changes around the steepest one, each less a share of it, down to that share
/// on both sides; between two places the change is taken to be linear. Px from the foot.
///   source   [WangOlson2016, section III-F]; the cut keeps a longer search on one side from
///   drawing
///            the mean there
float mean_place_of_changes(const NormalProfile& profile);

/// Where the values pass `level` going up, nearest to the steepest change, px from the foot;
/// between two values they are taken to be linear.
std::optional<float> crossing_place(const NormalProfile& profile, float level);

}  // namespace tagmint::detect
