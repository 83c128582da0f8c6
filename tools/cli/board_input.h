#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "board/board.h"
#include "draw/nested_tags.h"

namespace tagmint::cli {

/// Columns and rows.
struct GridSize {
  int columns = 0;
  int rows = 0;
};

/// Most columns or rows of a grid.
inline constexpr int kMostGridSide = 1000;

/// Reads "6x7": columns, then rows, each 1..kMostGridSide. Throws UsageError.
GridSize parse_grid(std::string_view text);

/// Reads a spacing into a gap in mm: a share of the edge, "0.3", or a length, "12mm". Throws
/// UsageError.
double parse_spacing_mm(std::string_view text, double edge_mm);

/// Reads "FAMILY:ID[:EDGE]", a tag for the hole of another. Throws UsageError, and InputError when
/// the family cannot be read.
draw::NestedRequest parse_nested(std::string_view text);

/// Reads "FAMILY:ID:EDGE@X,Y[,TURN]": a tag of a bundle with the place of its middle and its turn
/// clockwise, like "tag36h11:0:60mm@-40mm,0mm,90deg". Errors as parse_nested().
board::BoardTag parse_bundle_tag(std::string_view text);

/// Reads a bundle from a JSON file, "-" is stdin: {"tags": [{"family", "id", "edge_mm" or
/// "outer_mm", "center_mm": [x, y], "turn_deg"}]}; the turn may be left out. Throws InputError with
/// the place of the fault.
std::vector<board::BoardTag> read_bundle(const std::string& path);

}  // namespace tagmint::cli
