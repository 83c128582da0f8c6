// tags.yaml of apriltag_ros for ROS 1: each tag alone, and all as one bundle. Frames: x right, y
// up, z towards the viewer.
#include <fmt/format.h>

#include "board/board_notes.h"
#include "board/configs/config_numbers.h"
#include "board/configs/kinds.h"
#include "board/configs/requirements.h"

namespace tagmint::board {
namespace {

std::string bundle_row(const BoardTag& tag) {
  const HalfTurn turn = half_turn(tag.turn_deg);
  return fmt::format("{{id: {}, size: {}, x: {}, y: {}, z: 0.0, qw: {}, qx: 0.0, qy: 0.0, qz: {}}}",
                     tag.id, metres(tag.edge_mm), metres(tag.centre_mm.x), metres(-tag.centre_mm.y),
                     decimal(turn.w), decimal(turn.axis));
}

}  // namespace

std::string ros1_yaml(const Board& board) {
  require_one_plain_family(board, "apriltag_ros");
  std::string text = fmt::format("# for apriltag_ros (ROS 1); in settings.yaml: tag_family: '{}'\n",
                                 board.tags[0].family->name());
  text += fact_comments(board) + "standalone_tags:\n  [\n";
  for (const BoardTag& tag : board.tags) {
    text += fmt::format("    {{id: {}, size: {}, name: 'tag_{}'}},\n", tag.id, metres(tag.edge_mm),
                        tag.id);
  }
  text += "  ]\ntag_bundles:\n  [\n    {\n      name: 'board',\n      layout:\n        [\n";
  for (const BoardTag& tag : board.tags) text += "          " + bundle_row(tag) + ",\n";
  text += "        ]\n    }\n  ]\n";
  return text;
}

}  // namespace tagmint::board
