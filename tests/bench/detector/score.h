#pragma once

#include <span>
#include <vector>

#include "detector/picture_set.h"

namespace tagmint::bench {

/// What a contender's answers over a set come to.
struct Score {
  int tags = 0;       ///< that are in the pictures
  int found = 0;      ///< of them
  int false_ids = 0;  ///< reports that are no tag of the picture in its place, or one twice
  std::vector<double> corner_errors_px;
  std::vector<double> radial_errors_px;  ///< outwards from the tag's middle, by corner
  std::vector<double> size_errors;  ///< side found / true side - 1, by tag: 1 % too large seems
                                    ///< 1 % too near

  double recall() const { return tags > 0 ? static_cast<double>(found) / tags : 0; }
};

/// Adds one picture. A report is right when family and id are those of a tag whose middle is within
/// a quarter of a side.
void judge(std::span<const FoundTag> reports, const Picture& picture, Score& score);

/// The value below which a share of the values lies, 0 <= share <= 1; 0 when there are none.
double quantile(std::vector<double> values, double share);
/// Mean without the outer tenth on both sides, so that a misread corner does not decide it.
double trimmed_mean(std::vector<double> values);

}  // namespace tagmint::bench
