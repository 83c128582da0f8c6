#include "cli/commands.h"

#include <vector>

#include "cli/cmd_board.h"
#include "cli/cmd_check.h"
#include "cli/cmd_choose.h"
#include "cli/cmd_convert.h"
#include "cli/cmd_decode.h"
#include "cli/cmd_detect.h"
#include "cli/cmd_encode.h"
#include "cli/cmd_evaluate.h"
#include "cli/cmd_families.h"
#include "cli/cmd_generate.h"
#include "cli/cmd_identify.h"
#include "cli/cmd_info.h"
#include "cli/cmd_poster.h"
#include "cli/cmd_render.h"
#include "cli/cmd_sheet.h"

namespace tagmint::cli {

std::span<const Command> command_table() {
  // One line a command, and its header above.
  // clang-format off
  static const std::vector<Command> table = {
      families_command(),
      choose_command(),
      generate_command(),
      info_command(),
      check_command(),
      convert_command(),
      encode_command(),
      decode_command(),
      sheet_command(),
      board_command(),
      poster_command(),
      render_command(),
      detect_command(),
      identify_command(),
      evaluate_command(),
  };
  // clang-format on
  return table;
}

}  // namespace tagmint::cli
