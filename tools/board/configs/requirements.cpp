#include "board/configs/requirements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "board/configs/board_config.h"

namespace tagmint::board {
namespace {

constexpr std::array<std::string_view, 9> kFamilies = {
    "tag16h5",          "tag25h9",        "tag36h10",       "tag36h11",        "tagCircle21h7",
    "tagStandard41h12", "tagCircle49h12", "tagCustom48h12", "tagStandard52h13"};

}  // namespace

std::span<const std::string_view> libapriltag_families() { return kFamilies; }

void require_one_plain_family(const Board& board, std::string_view program) {
  const codec::Family& first = *board.tags.at(0).family;
  for (const BoardTag& tag : board.tags) {
    if (tag.family->name() != first.name()) {
      throw NotExpressible(
          fmt::format("{} knows tags by their id alone, and the board has tags of {} and {}",
                      program, first.name(), tag.family->name()),
          "--config", "make a board of one family, or write the kind tagmint");
    }
    if (has_wide_border(tag)) {
      throw NotExpressible(
          fmt::format("{} finds tags with a black border of one cell, and the board has a wider "
                      "one, as Kalibr's targets have",
                      program),
          "--config", "give --border 1");
    }
  }
}

void require_libapriltag_family(const Board& board, std::string_view program) {
  const std::string& name = board.tags.at(0).family->name();
  if (std::find(kFamilies.begin(), kFamilies.end(), name) != kFamilies.end()) return;
  throw NotExpressible(
      fmt::format("{} has a list of families, and {} is not in it", program, name), "--config",
      fmt::format("take one of {}, or write the kind tagmint", fmt::join(kFamilies, ", ")));
}

}  // namespace tagmint::board
