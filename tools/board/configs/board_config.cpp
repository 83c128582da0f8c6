#include "board/configs/board_config.h"

#include <array>
#include <cstddef>

#include "board/configs/kinds.h"

namespace tagmint::board {
namespace {

struct Kind {
  ConfigKind kind;
  std::string (*write)(const Board& board);
};

constexpr std::array<Kind, 5> kKinds = {{{ConfigKind::Kalibr, kalibr_yaml},
                                         {ConfigKind::Ros1, ros1_yaml},
                                         {ConfigKind::Ros2, ros2_yaml},
                                         {ConfigKind::Wpilib, wpilib_json},
                                         {ConfigKind::Tagmint, tagmint_json}}};

}  // namespace

std::span<const std::string> config_kind_names() {
  static const std::array<std::string, kKinds.size()> names = {"kalibr", "ros1", "ros2", "wpilib",
                                                               "tagmint"};
  return names;
}

const std::string& name_of(ConfigKind kind) {
  return config_kind_names()[static_cast<std::size_t>(kind)];
}

std::string board_config(ConfigKind kind, const Board& board) {
  return kKinds[static_cast<std::size_t>(kind)].write(board);
}

}  // namespace tagmint::board
