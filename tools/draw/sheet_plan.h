#pragma once

#include <cstddef>
#include <vector>

#include "tagmint/codec/errors.h"
#include "tagmint/codec/family.h"

namespace tagmint::draw {

/// Longest side of a page: PDF programs take no more than 14,400 units of 1/72 inch.
inline constexpr double kMaxPageMm = 5080.0;

/// A rectangle on a page, in mm from the page's top-left corner; x right, y down.
struct Box {
  double x_mm = 0.0;
  double y_mm = 0.0;
  double width_mm = 0.0;
  double height_mm = 0.0;
  double right_mm() const { return x_mm + width_mm; }
  double bottom_mm() const { return y_mm + height_mm; }
};

/// Tags of one family and one size.
struct TagGroup {
  codec::SharedFamily family;
  double edge_mm = 0.0;           ///< side of the border square, > 0
  std::vector<codec::TagId> ids;  ///< in the order of placing
};

/// Side of the whole tag for a border square of side `edge_mm`, and the other way round.
double outer_of_edge(const codec::Layout& layout, double edge_mm);
double edge_of_outer(const codec::Layout& layout, double outer_mm);

/// Cells that must stay white around the tag: 0 where its own outer ring is white all round,
/// else 1.
int quiet_cells(const codec::Layout& layout);

/// Width of the white that is kept free around the whole tag, in mm, for a quiet zone of
/// `quiet_zone_cells` (0 or more) in all: a white ring of the tag's own counts as one cell.
double quiet_zone_mm(const codec::Layout& layout, double edge_mm, double quiet_zone_cells);

/// Distance from the tag's middle to the farthest corner of a cell that it has, in cells. Round
/// tags do not reach into the corners of their grid.
double radius_cells(const codec::Layout& layout);

/// The edge nearest to `edge_mm` of which each cell is a whole number of dots, at least one.
///   dpi   dots per inch, > 0
double whole_dot_edge(const codec::Layout& layout, double edge_mm, double dpi);

/// How a tag is cut out.
enum class CutShape {
  Square,   ///< the tag's slot: tag, quiet zone and label
  Rounded,  ///< the same with round corners, which lie in the gap
  Circle,   ///< a circle around the tag and its quiet zone; the label stays outside
};

/// What a page leaves to the tags, and how they stand there.
struct SheetOptions {
  double page_width_mm = 210.0;
  double page_height_mm = 297.0;
  double margin_mm = 10.0;        ///< kept free on all four sides
  double gap_mm = 5.0;            ///< between neighbouring slots
  int columns = 0;                ///< of a page; 0 = as many as fit
  int rows = 0;                   ///< of a page; 0 = as many as fit
  double label_mm = 0.0;          ///< height below each tag that its label takes; 0 = no labels
  double header_mm = 0.0;         ///< height at the top, inside the margin, for a title
  double footer_mm = 0.0;         ///< height at the bottom, inside the margin, for notes
  double side_mm = 0.0;           ///< width at the left, inside the margin, for an upright ruler
  double quiet_zone_cells = 1.0;  ///< see quiet_zone_mm()
  CutShape cut_shape = CutShape::Square;
  double dot_mm =
      0.0;  ///< tags start at whole multiples of it, moved by at most half; 0 = anywhere
};

/// A tag's place.
struct PlacedTag {
  std::size_t group = 0;  ///< index into SheetPlan::groups
  codec::TagId id = 0;
  Box outer;              ///< the whole tag
  Box slot;               ///< the tag, its quiet zone and its label: nothing else is drawn in here
  double quiet_mm = 0.0;  ///< width of the quiet zone around `outer`
};

struct SheetPage {
  std::vector<PlacedTag> tags;  ///< row by row
};

/// How many tags of a group a page takes.
struct GroupGrid {
  int columns = 0;
  int rows = 0;
};

/// Where everything goes.
struct SheetPlan {
  SheetOptions options;
  std::vector<TagGroup> groups;
  std::vector<GroupGrid> grids;  ///< one a group: of a page that this group has for itself
  std::vector<SheetPage> pages;

  /// The page without its margin.
  Box area() const;
  std::size_t tag_count() const;
};

/// What was asked for has no place on the page; the message says what would.
class DoesNotFit : public codec::Fault {
 public:
  using Fault::Fault;
};

/// Places all tags on as many pages as they need. Each group stands in rows of its own, centred on
/// the page; all pages share the distance from the top, chosen so that the fullest is centred.
/// Throws DoesNotFit when not even one tag, or not the rows and columns asked for, fit on a page;
/// std::invalid_argument for sizes that are not positive (page, edge) or negative (the others), a
/// group without family or ids, or an id that its family does not have.
SheetPlan plan_sheet(std::vector<TagGroup> groups, const SheetOptions& options);

/// One tag on a page of its own: the tag, its quiet zone, `options.margin_mm` and the label. The
/// page's size and the grid in `options` are not looked at. Errors as plan_sheet(), DoesNotFit for
/// a page larger than kMaxPageMm.
SheetPlan plan_single(const codec::SharedFamily& family, double edge_mm, codec::TagId id,
                      SheetOptions options);

}  // namespace tagmint::draw
