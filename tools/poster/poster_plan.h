#pragma once

#include <span>
#include <vector>

#include "draw/nested_tags.h"
#include "draw/sheet_plan.h"
#include "tagmint/codec/family.h"

namespace tagmint::poster {

/// Which way the paper lies. A poster is square, so all rows of one orientation take as many pages
/// as all rows of the other; rows of both may take fewer.
enum class Orientation { FewestPages, AsGiven, Turned };

/// The paper that a poster is printed on.
struct PosterOptions {
  double paper_width_mm = 210.0;
  double paper_height_mm = 297.0;
  double margin_mm = 10.0;   ///< free of the poster on all four sides; marks and numbers go there
  double overlap_mm = 10.0;  ///< what neighbouring pages show both
  Orientation orientation = Orientation::FewestPages;
};

/// Least margin: below, the marks and the page's number have no room.
inline constexpr double kLeastMarginMm = 6.0;

/// A tag on the poster, in its middle.
struct PosterTag {
  codec::SharedFamily family;
  codec::TagId id = 0;
  double edge_mm = 0.0;  ///< side of the border square
};

/// What one page shows. Poster coordinates: mm from the top-left corner of the poster, which is the
/// tag with its quiet zone; x right, y down.
struct PosterPage {
  int row = 0;     ///< from 0, top to bottom
  int column = 0;  ///< from 0, left to right
  draw::Box part;  ///< printed area, poster coordinates; reaches beyond the poster on its rim
  bool all_white = false;  ///< no black cell reaches it
};

/// How a poster is cut into pages. Each page but those of the first column and row is cut along the
/// left and upper side of its part and laid over its neighbours, whose last `overlap_mm` show the
/// same; the rim of the poster is cut last.
struct PosterPlan {
  std::vector<PosterTag> tags;  ///< the tag, and those in its hole, from the outside inwards
  double side_mm = 0.0;         ///< of the poster: tag and quiet zone
  double margin_mm = 0.0;
  double overlap_mm = 0.0;
  std::vector<int> columns;       ///< pages of each row; all of a row lie the same way
  std::vector<PosterPage> pages;  ///< row by row; all of them, also those that are all white

  int rows() const { return static_cast<int>(columns.size()); }
  /// Where a tag stands, poster coordinates: its border square or the whole tag.
  draw::Box border_square(const PosterTag& tag) const;
  draw::Box outer(const PosterTag& tag) const;
  /// Sides of the paper of a page.
  double page_width_mm(const PosterPage& page) const { return page.part.width_mm + 2 * margin_mm; }
  double page_height_mm(const PosterPage& page) const {
    return page.part.height_mm + 2 * margin_mm;
  }
};

/// Plans a poster of one tag on as few pages as will do.
///   nested   tags that stand in its hole, outermost first
/// Throws draw::DoesNotFit where margins and overlap leave too little of the paper, a nested tag
/// does not fit, or there would be more than 10,000 pages; std::invalid_argument for sizes that are
/// not positive (paper, edge) or negative (overlap), a margin below kLeastMarginMm, or an id that
/// is not the family's.
PosterPlan plan_poster(const PosterTag& tag, std::span<const draw::NestedRequest> nested,
                       const PosterOptions& options);

}  // namespace tagmint::poster
