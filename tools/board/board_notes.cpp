#include "board/board_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "draw/units.h"

namespace tagmint::board {
namespace {

using draw::format_mm;

/// Tags that look the same but for their ids.
struct Kind {
  const BoardTag* first;
  std::vector<codec::TagId> ids;
};

std::vector<Kind> kinds_of(const Board& board) {
  std::vector<Kind> kinds;
  for (const BoardTag& tag : board.tags) {
    const auto same = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& kind) {
      return kind.first->family->name() == tag.family->name() &&
             kind.first->edge_mm == tag.edge_mm &&
             kind.first->host.has_value() == tag.host.has_value();
    });
    if (same == kinds.end()) {
      kinds.push_back({&tag, {tag.id}});
    } else {
      same->ids.push_back(tag.id);
    }
  }
  return kinds;
}

std::string describe(const Kind& kind) {
  return fmt::format("{}: edge {}, outer {}{}, {} {}", kind.first->family->name(),
                     format_mm(kind.first->edge_mm), format_mm(outer_mm(*kind.first)),
                     kind.first->host ? ", in the hole" : "", kind.ids.size() == 1 ? "id" : "ids",
                     format_ids(kind.ids));
}

std::string describe(const Grid& grid) {
  std::string text = fmt::format(
      "{} x {} tags, ids from the {} left, spacing {:.6g} (gap {})", grid.columns, grid.rows,
      grid.style == Style::Kalibr ? "bottom" : "top", grid.spacing(), format_mm(grid.gap_mm));
  if (grid.border_cells > 1) text += fmt::format(", border of {} cells", grid.border_cells);
  return text;
}

}  // namespace

std::string format_ids(std::vector<codec::TagId> ids) {
  std::sort(ids.begin(), ids.end());
  std::string text;
  for (std::size_t begin = 0; begin < ids.size();) {
    std::size_t end = begin + 1;
    while (end < ids.size() && ids[end] == ids[end - 1] + 1) ++end;
    if (begin > 0) text += ", ";
    text += end - begin == 1 ? fmt::format("{}", ids[begin])
                             : fmt::format("{}-{}", ids[begin], ids[end - 1]);
    begin = end;
  }
  return text;
}

std::vector<std::string> board_facts(const Board& board) {
  std::vector<std::string> lines;
  for (const Kind& kind : kinds_of(board)) lines.push_back(describe(kind));
  if (board.grid) lines.push_back(describe(*board.grid));
  return lines;
}

std::vector<std::string> board_notes(const Board& board) {
  std::vector<std::string> lines = board_facts(board);
  lines.emplace_back("print at 100 %, not fitted to the page");
  return lines;
}

std::string fact_comments(const Board& board) {
  std::string text;
  for (const std::string& line : board_facts(board)) text += "# " + line + "\n";
  return text;
}

}  // namespace tagmint::board
