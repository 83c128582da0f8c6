// Parameters of apriltag_ros for ROS 2. It knows single tags and their sizes, no places.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "board/board_notes.h"
#include "board/configs/config_numbers.h"
#include "board/configs/kinds.h"
#include "board/configs/requirements.h"

namespace tagmint::board {

std::string ros2_yaml(const Board& board) {
  constexpr std::string_view kProgram = "apriltag_ros for ROS 2";
  require_one_plain_family(board, kProgram);
  require_libapriltag_family(board, kProgram);
  const codec::Family& family = *board.tags[0].family;
  std::vector<std::string> ids, frames, sizes;
  for (const BoardTag& tag : board.tags) {
    ids.push_back(std::to_string(tag.id));
    frames.push_back(fmt::format("'{}:{}'", family.name(), tag.id));
    sizes.push_back(metres(tag.edge_mm));
  }
  return fmt::format(
      "# parameters of apriltag_ros (ROS 2)\n"
      "{}"
      "/**:\n"
      "  ros__parameters:\n"
      "    family: '{}'\n"
      "    size: {}\n"
      "    max_hamming: {}\n"
      "    tag:\n"
      "      ids: [{}]\n"
      "      frames: [{}]\n"
      "      sizes: [{}]\n",
      fact_comments(board), family.name().substr(std::string_view("tag").size()), sizes[0],
      std::min(2, family.max_safe_errors()), fmt::join(ids, ", "), fmt::join(frames, ", "),
      fmt::join(sizes, ", "));
}

}  // namespace tagmint::board
