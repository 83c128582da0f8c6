// Our own kind: every tag's family, id, edge and the four corners of its border square. Frame: x
// right, y down, z away from the viewer, metres.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "board/configs/config_numbers.h"
#include "board/configs/kinds.h"
#include "tagmint/codec/version.h"

namespace tagmint::board {
namespace {

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string point(const detect::Point& p) {
  return fmt::format("[{}, {}, 0.0]", metres(p.x), metres(p.y));
}

std::string corners(const BoardTag& tag) {
  const detect::Corners c = border_corners(tag);
  return fmt::format("[{}, {}, {}, {}]", point(c[0]), point(c[1]), point(c[2]), point(c[3]));
}

/// The black border's width where it is not that of the family.
std::string border(const Board& board, const BoardTag& tag) {
  if (!has_wide_border(tag)) return "";
  return fmt::format("\"border_cells\": {}, ", board.grid->border_cells);
}

std::string host(const Board& board, const BoardTag& tag) {
  if (!tag.host) return "";
  const BoardTag& outer = board.tags[*tag.host];
  return fmt::format(", \"inside\": {{\"family\": {}, \"id\": {}}}", quoted(outer.family->name()),
                     outer.id);
}

std::string tag_row(const Board& board, const BoardTag& tag) {
  return fmt::format(
      "  {{\"family\": {}, \"id\": {}, {}\"edge_m\": {}, \"outer_m\": {}, \"turn_deg\": {}, "
      "\"center\": {}, \"corners\": {}{}}}",
      quoted(tag.family->name()), tag.id, border(board, tag), metres(tag.edge_mm),
      metres(outer_mm(tag)), decimal(tag.turn_deg), point(tag.centre_mm), corners(tag),
      host(board, tag));
}

std::string grid_line(const Grid& grid) {
  return fmt::format(
      " \"grid\": {{\"columns\": {}, \"rows\": {}, \"style\": \"{}\", \"border_cells\": {}, "
      "\"gap_m\": {}, \"spacing\": {}}},\n",
      grid.columns, grid.rows, grid.style == Style::Kalibr ? "kalibr" : "plain", grid.border_cells,
      metres(grid.gap_mm), decimal(grid.spacing()));
}

/// Family and edge, where all tags share them.
std::string shared_facts(const Board& board) {
  const BoardTag& first = board.tags[0];
  const auto all = [&](auto same) {
    return std::all_of(board.tags.begin(), board.tags.end(), same);
  };
  std::string text;
  if (all([&](const BoardTag& t) { return t.family->name() == first.family->name(); })) {
    text += fmt::format(" \"family\": {},\n", quoted(first.family->name()));
  }
  if (all([&](const BoardTag& t) { return t.edge_mm == first.edge_mm; })) {
    text += fmt::format(" \"edge_m\": {},\n", metres(first.edge_mm));
  }
  return text;
}

}  // namespace

std::string tagmint_json(const Board& board) {
  const draw::Box& extent = board.extent;
  std::string text =
      fmt::format("{{\"format\": \"tagmint-board\", \"version\": 1, \"program\": \"tagmint {}\",\n",
                  codec::kVersion);
  text +=
      " \"frame\": \"x right, y down, z away from the viewer; metres; corners: bottom left, bottom "
      "right, top right, top left\",\n";
  text += fmt::format(
      " \"extent\": {{\"left\": {}, \"top\": {}, \"width\": {}, \"height\": {}}},\n",
      metres(extent.x_mm), metres(extent.y_mm), metres(extent.width_mm), metres(extent.height_mm));
  if (board.grid) text += grid_line(*board.grid);
  text += shared_facts(board) + " \"tags\": [\n";
  for (std::size_t i = 0; i < board.tags.size(); ++i) {
    text += tag_row(board, board.tags[i]) + (i + 1 < board.tags.size() ? ",\n" : "\n");
  }
  return text + " ]}\n";
}

}  // namespace tagmint::board
