#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "board/board.h"
#include "board/configs/board_config.h"

namespace tagmint::cli {

/// A config file that is asked for.
struct ConfigTarget {
  board::ConfigKind kind = board::ConfigKind::Tagmint;
  std::string path;
};

/// Reads "[KIND:]FILE". Without KIND the file's name tells it: a kind's name in it
/// (ros1_tags.yaml), else tags.yaml is ros1, other .json is tagmint, and other .yaml is kalibr for
/// a board in that style. Throws UsageError where that leaves it open.
ConfigTarget parse_config_target(std::string_view text, board::Style style);

}  // namespace tagmint::cli
