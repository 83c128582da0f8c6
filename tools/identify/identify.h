#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "identify/evidence.h"
#include "identify/reading.h"
#include "tagmint/codec/family.h"
#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::identify {

/// What one tag of a picture may be.
struct Candidate {
  codec::SharedFamily family;
  codec::TagId id = 0;
  int hamming = 0;                        ///< cells that differ
  bool mirrored = false;                  ///< left and right are exchanged, ...
  double turned_deg = 0;                  ///< ...then it is turned clockwise as seen; 0 <= . < 360
  bool inverted = false;                  ///< black and white are exchanged
  BorderPart border = BorderPart::Whole;  ///< what of its border is in the picture
  bool quiet_zone = false;                ///< whether what should stay empty around it is, too
  detect::Corners corners;                ///< images of detect::kTagCorners, px
  Doubt doubt;                            ///< what there is to say against it
  double accept_rate = 0;                 ///< share of random words that are as near to the family
  /// Matches at least as convincing that are to be expected by accident among all words that were
  /// looked at in the picture with no more doubt, for each about as convincing match that was
  /// found.
  double expected_accidents = 0;
};

/// Most expected accidents of a candidate that is believed: of a clear one, which only weak
/// families (tag16h5, rot16h5) come near to, and of one whose cells are in doubt or whose place a
/// better one explains already.
inline constexpr double kMostAccidents = 0.15;
inline constexpr double kMostAccidentsDoubtful = 0.03;

/// One tag of the picture: what it may be, the most convincing first; at least one.
using TagInPicture = std::vector<Candidate>;

struct Identification {
  /// Largest first. Empty where nothing is believed.
  std::vector<TagInPicture> tags;
  /// Where nothing is believed: what was the least unlikely, if any square had a border.
  std::optional<Candidate> nearest;
};

/// Finds out which tags pictures show: by exact grids of cells, as the squares that a detector
/// sees, as squares that the picture's edge cuts, and as one tag that fills the picture, also where
/// its border was cut away; mirrored or not, inverted or not, turned in any way. Later ways are
/// only tried where the earlier ones gave nothing to believe.
///
/// Believed are candidates that are not plain (is_plain()), with at most as many wrong cells as
/// their family always corrects, and no more expected accidents than the limits above. Of one tag
/// all believed ones are told: families that share tags, or a family that contains the mirror
/// image.
///
/// Keeps its tables and scratch memory, so it serves one caller at a time.
class Identifier {
 public:
  /// Throws std::invalid_argument where a family is null or given twice.
  ///   threads    0 = all cores; the results do not depend on it
  explicit Identifier(std::vector<codec::SharedFamily> families, int threads = 0);
  ~Identifier();
  Identifier(Identifier&&) noexcept;
  Identifier& operator=(Identifier&&) noexcept;

  /// Any size of picture.
  ///   cost   that of a detection, of up to five where there is nothing to find, and four
  ///   comparisons
  ///          for each word seen and tag of the smaller families of its layout, a look-up in the
  ///          others
  Identification identify(detect::ImageView picture);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tagmint::identify
