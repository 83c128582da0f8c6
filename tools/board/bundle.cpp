#include "board/bundle.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "board/clearance.h"

namespace tagmint::board {

Board plan_bundle(std::vector<BoardTag> tags) {
  if (tags.empty()) throw std::invalid_argument("a board needs at least one tag");
  for (const BoardTag& tag : tags) {
    if (!std::isfinite(tag.edge_mm) || tag.edge_mm <= 0) {
      throw std::invalid_argument(
          fmt::format("an edge of {} mm cannot be; it is above 0", tag.edge_mm));
    }
    if (!std::isfinite(tag.centre_mm.x) || !std::isfinite(tag.centre_mm.y) ||
        !std::isfinite(tag.turn_deg)) {
      throw std::invalid_argument("the place of a tag is not a finite number");
    }
    if (tag.id >= tag.family->size()) {
      throw std::invalid_argument(fmt::format("id {} is not in {}; its ids are 0-{}", tag.id,
                                              tag.family->name(), tag.family->size() - 1));
    }
  }
  Board board;
  board.tags = std::move(tags);
  check_clearance(board.tags);
  board.extent = extent_of(board.tags);
  return board;
}

}  // namespace tagmint::board
