// The target file of Kalibr, "aprilgrid". It names neither family nor ids nor border: they are
// implied, and so is the frame.
#include <fmt/format.h>

#include "board/board_notes.h"
#include "board/configs/board_config.h"
#include "board/configs/config_numbers.h"
#include "board/configs/kinds.h"

namespace tagmint::board {
namespace {

constexpr int kBorderCells = 2;

void refuse(const std::string& what, const std::string& mend) {
  throw NotExpressible("Kalibr's target file cannot say this board: " + what, "--config", mend);
}

void require_kalibr(const Board& board) {
  if (!board.grid) refuse("it describes grids only", "give --grid, or write the kind tagmint");
  const Grid& grid = *board.grid;
  const std::string& family = board.tags[0].family->name();
  if (family != "tag36h11") {
    refuse("the family is not told and tag36h11 is meant, not " + family,
           "take tag36h11, or write the kind tagmint");
  }
  if (grid.style != Style::Kalibr) {
    refuse("ids run from the bottom left with black squares between the tags",
           "give --style kalibr");
  }
  if (grid.border_cells != kBorderCells) {
    refuse(fmt::format("the border is not told and two cells are meant, not {}", grid.border_cells),
           "give --border 2");
  }
  for (std::size_t i = 0; i < board.tags.size(); ++i) {
    if (board.tags[i].id != i) {
      refuse("ids are not told and 0, 1, 2, ... are meant", "leave --first-id and --ids out");
    }
  }
}

}  // namespace

std::string kalibr_yaml(const Board& board) {
  require_kalibr(board);
  const Grid& grid = *board.grid;
  return fact_comments(board) + fmt::format(
                                    "target_type: 'aprilgrid'\n"
                                    "tagCols: {}\n"
                                    "tagRows: {}\n"
                                    "tagSize: {}  # edge of a tag's black border, m\n"
                                    "tagSpacing: {}  # gap between tags / tagSize\n",
                                    grid.columns, grid.rows, metres(grid.edge_mm),
                                    decimal(grid.spacing()));
}

}  // namespace tagmint::board
