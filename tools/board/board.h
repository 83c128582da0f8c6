#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "draw/sheet_plan.h"
#include "tagmint/codec/family.h"
#include "tagmint/codec/tag_cells.h"
#include "tagmint/detect/geometry.h"

namespace tagmint::board {

/// A tag and its place on a board. Board coordinates are those of a tag's plane
/// (docs/conventions.md): x right, y down, z away from the viewer; in mm.
struct BoardTag {
  codec::SharedFamily family;
  codec::Layout layout;  ///< as printed: the family's, or that with a wider black border
  codec::TagId id = 0;
  double edge_mm = 0.0;             ///< side of the border square
  detect::Point centre_mm;          ///< of the border square
  double turn_deg = 0.0;            ///< clockwise as seen
  std::optional<std::size_t> host;  ///< index of the tag in whose hole it stands
};

/// A tag as its family has it.
BoardTag make_tag(const codec::SharedFamily& family, codec::TagId id, double edge_mm,
                  detect::Point centre_mm, double turn_deg = 0.0);

/// What the gaps between the tags of a grid hold.
enum class Style { Plain, Kalibr };

/// How the tags of a grid stand; for boards that are one.
struct Grid {
  int columns = 0;
  int rows = 0;
  double edge_mm = 0.0;
  double gap_mm = 0.0;  ///< between neighbouring border squares
  Style style = Style::Plain;
  int border_cells = 1;  ///< width of the black border of classic layouts

  /// The gap as a share of the edge.
  double spacing() const { return gap_mm / edge_mm; }
};

/// Tags that keep their places to each other.
struct Board {
  std::vector<BoardTag> tags;
  std::vector<draw::Box> squares;  ///< black squares between tags, board coordinates
  draw::Box extent;                ///< holds all tags with their quiet zones and all squares
  std::optional<Grid> grid;
};

/// A place on the tag, in mm from its middle along its own axes, in board coordinates.
detect::Point on_board(const BoardTag& tag, detect::Point on_tag_mm);

/// The corners of the tag's border square, in board coordinates and in the order of
/// detect::kTagCorners.
detect::Corners border_corners(const BoardTag& tag);

/// A square of side `side_mm` around the tag's middle, turned with it; corners in the same order.
detect::Corners square_around(const BoardTag& tag, double side_mm);

/// Side of the whole tag.
double outer_mm(const BoardTag& tag);

/// The tag's picture in its printed layout.
codec::TagCells cells_of(const BoardTag& tag);

/// Whether the printed border is wider than the family's own.
bool has_wide_border(const BoardTag& tag);

/// Whether the border square of a layout is the outer edge of a black ring that only white
/// surrounds, as in classic layouts: its border can be made wider, and squares can touch its
/// corners.
bool is_black_on_white(const codec::Layout& layout);

/// The layout with a black border of `border_cells` instead of one cell around the same data. The
/// border square grows with it; codewords stay.
///   layout   is_black_on_white()
/// Throws std::invalid_argument for another layout or a width outside 1..4.
codec::Layout with_border(const codec::Layout& layout, int border_cells);

}  // namespace tagmint::board
