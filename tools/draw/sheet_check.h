#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "draw/read_back.h"
#include "draw/sheet_plan.h"
#include "tagmint/detect/detector.h"

namespace tagmint::draw {

/// A tag that a page does not show as its plan has it.
struct TagFault {
  std::string family;
  codec::TagId id = 0;
  std::string what;  ///< "is not found", "is 0.3 mm from its place"
};

/// What the look at a page told.
struct PageCheck {
  std::size_t tags = 0;           ///< found as planned, before the first fault
  double largest_error_mm = 0.0;  ///< of their corners
  std::optional<TagFault> fault;  ///< the first one, in the order of the plan
};

/// Reads drawn pages with the detector of this library and compares each tag's id, place and size
/// with a plan.
class SheetChecker {
 public:
  ///   groups     all that the pages may show
  ///   inverted   the pages have ink where tags are white
  SheetChecker(std::span<const TagGroup> groups, bool inverted);

  /// At how many pixels per inch a page should be drawn to be read.
  static double reading_dpi(const SheetPlan& plan, std::size_t page);

  /// Looks at a page. A corner of the border square may be 0.05 mm from its place, or 0.3 pixel
  /// where that is more.
  ///   slack_mm   allowed besides: of pictures whose edges were rounded to dots
  PageCheck check(ReadPage drawn, const SheetPlan& plan, std::size_t page, double slack_mm = 0.0);

 private:
  bool inverted_;
  detect::Detector detector_;
};

/// Where a plan has the corners of a tag's border square, in mm, in the order of
/// detect::kTagCorners.
detect::Corners planned_corners_mm(const SheetPlan& plan, const PlacedTag& tag);

}  // namespace tagmint::draw
