#include "scene/board_reader.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "board/grid_board.h"
#include "scene/place_reader.h"

namespace tagmint::scene {
namespace {

constexpr double kMetres = 1e-3;  // of a board's millimetres

board::Grid read_grid(const JsonValue& value) {
  constexpr std::uint64_t kMost = 1000;  // columns and rows
  const std::vector<JsonValue> sides = value.at("grid").elements();
  if (sides.size() != 2) value.at("grid").fail("is no pair of numbers", "give [columns, rows]");
  board::Grid grid;
  grid.columns = static_cast<int>(sides[0].whole(1, kMost));
  grid.rows = static_cast<int>(sides[1].whole(1, kMost));
  grid.edge_mm = value.at("edge_m").number(1e-9, 1e9) / kMetres;
  grid.gap_mm = (value.has("spacing") ? value.at("spacing").number(1e-6, 1e6) : 0.3) * grid.edge_mm;
  if (value.has("style")) {
    const std::string style = value.at("style").text();
    if (style != "plain" && style != "kalibr") {
      value.at("style").fail("is '" + style + "'", "write \"plain\" or \"kalibr\"");
    }
    if (style == "kalibr") grid.style = board::Style::Kalibr;
  }
  grid.border_cells = grid.style == board::Style::Kalibr ? 2 : 1;
  if (value.has("border_cells")) {
    grid.border_cells = static_cast<int>(value.at("border_cells").whole(1, 4));
  }
  return grid;
}

board::Board plan(const JsonValue& value, const codec::SharedFamily& family) {
  const board::Grid grid = read_grid(value);
  const std::size_t places = static_cast<std::size_t>(grid.columns) * grid.rows;
  const std::size_t most = family->size() - std::min(places, family->size());
  if (places > family->size()) {
    value.at("grid").fail("has " + std::to_string(places) + " places",
                          family->name() + " has " + std::to_string(family->size()) + " tags");
  }
  std::vector<codec::TagId> ids(places);
  std::iota(
      ids.begin(), ids.end(),
      static_cast<codec::TagId>(value.has("first_id") ? value.at("first_id").whole(0, most) : 0));
  try {
    return board::plan_grid(family, grid, ids);
  } catch (const draw::DoesNotFit& fault) {
    value.fail("does not fit: " + std::string(fault.what()), "widen \"spacing\"");
  } catch (const std::invalid_argument& fault) {
    value.fail("cannot be: " + std::string(fault.what()), "change the board");
  }
}

SheetBox in_metres(const draw::Box& box) {
  return {box.x_mm * kMetres, box.y_mm * kMetres, box.width_mm * kMetres, box.height_mm * kMetres};
}

/// The place of a tag that is not turned on a board of the given pose.
PosedTag on_board(const board::BoardTag& tag, const detect::Pose& board) {
  PosedTag posed{.pose = board, .edge_m = tag.edge_mm * kMetres};
  const detect::Point centre = kMetres * tag.centre_mm;
  for (std::size_t row = 0; row < 3; ++row) {
    posed.pose.t[row] += board.R[row * 3] * centre.x + board.R[row * 3 + 1] * centre.y;
  }
  return posed;
}

}  // namespace

void add_board(const JsonValue& value, SceneFamilies& families, Scene& scene) {
  value.require_keys({"family", "grid", "edge_m", "spacing", "first_id", "style", "border_cells",
                      "pose", "position_m", "rotation_deg"});
  const board::Board planned = plan(value, families.get(value.at("family").text()));
  Sheet sheet{.pose = read_pose(value), .paper = in_metres(planned.extent)};
  for (const draw::Box& square : planned.squares) sheet.black.push_back(in_metres(square));
  sheet.first_tag = scene.tags.size();
  for (const board::BoardTag& tag : planned.tags) {
    scene.tags.push_back(
        {.family = tag.family,
         .id = tag.id,
         .place = on_board(tag, sheet.pose),
         .on_sheet = std::make_shared<const OnSheet>(OnSheet{scene.sheets.size(), tag.layout})});
  }
  scene.sheets.push_back(std::move(sheet));
}

}  // namespace tagmint::scene
