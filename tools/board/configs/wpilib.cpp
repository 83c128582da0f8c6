// A field layout of WPILib. The board stands upright in the plane x = 0 of the field and looks
// along +x; seen by a viewer before it, y goes right and z up, from its bottom left corner.
#include <fmt/format.h>

#include <cmath>

#include "board/configs/board_config.h"
#include "board/configs/config_numbers.h"
#include "board/configs/kinds.h"
#include "board/configs/requirements.h"

namespace tagmint::board {
namespace {

constexpr std::string_view kProgram = "WPILib";

void require_one_size(const Board& board) {
  const double edge = board.tags[0].edge_mm;
  for (const BoardTag& tag : board.tags) {
    if (std::abs(tag.edge_mm - edge) > 1e-9) {
      throw NotExpressible(
          "a field layout of WPILib has no sizes: all tags are of one, and those of the board are "
          "not",
          "--config", "make all tags of one edge, or write the kind tagmint");
    }
  }
}

std::string tag_row(const BoardTag& tag, const draw::Box& extent) {
  const HalfTurn turn = half_turn(tag.turn_deg);
  return fmt::format(
      "  {{\"ID\": {}, \"pose\": {{\"translation\": {{\"x\": 0.0, \"y\": {}, \"z\": {}}}, "
      "\"rotation\": {{\"quaternion\": {{\"W\": {}, \"X\": {}, \"Y\": 0.0, \"Z\": 0.0}}}}}}}}",
      tag.id, metres(tag.centre_mm.x - extent.x_mm), metres(extent.bottom_mm() - tag.centre_mm.y),
      decimal(turn.w), decimal(turn.axis));
}

}  // namespace

std::string wpilib_json(const Board& board) {
  require_one_plain_family(board, kProgram);
  require_libapriltag_family(board, kProgram);
  require_one_size(board);
  std::string text = "{\"tags\": [\n";
  for (std::size_t i = 0; i < board.tags.size(); ++i) {
    text += tag_row(board.tags[i], board.extent) + (i + 1 < board.tags.size() ? ",\n" : "\n");
  }
  // The floor before the board, as deep as the board is wide.
  const std::string side = metres(board.extent.width_mm);
  return text + fmt::format(" ],\n \"field\": {{\"length\": {}, \"width\": {}}}}}\n", side, side);
}

}  // namespace tagmint::board
