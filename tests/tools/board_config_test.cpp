#include "board/configs/board_config.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "board/configs/config_numbers.h"
#include "support/board_samples.h"

namespace tagmint::board {
namespace {

using nlohmann::json;
using test::kalibr_board;
using test::mixed_bundle;
using test::sample_bundle;
using test::sample_grid;

constexpr Grid kPlain = {.columns = 3, .rows = 2, .edge_mm = 40, .gap_mm = 10};

std::string refusal(ConfigKind kind, const Board& board) {
  try {
    board_config(kind, board);
  } catch (const NotExpressible& fault) {
    return fault.what();
  }
  return "";
}

void expect_refusal(ConfigKind kind, const Board& board, const std::string& part) {
  const std::string text = refusal(kind, board);
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(ConfigNumbers, DecimalsAreExactAndNeverWhole) {
  EXPECT_EQ(metres(88), "0.088");
  EXPECT_EQ(metres(1000), "1.0");
  EXPECT_EQ(metres(0), "0.0");
  EXPECT_EQ(metres(-0.0), "0.0");
  EXPECT_EQ(metres(-1e-12), "0.0");
  EXPECT_EQ(metres(100.0 / 3), "0.033333333333");
  EXPECT_EQ(decimal(0.1 + 0.2), "0.3");
}

TEST(ConfigNumbers, HalfTurnsAreUnitQuaternionsWithAPositiveRealPart) {
  for (double turn = -360; turn <= 360; turn += 7.5) {
    const HalfTurn half = half_turn(turn);
    EXPECT_NEAR(half.w * half.w + half.axis * half.axis, 1, 1e-15);
    EXPECT_GE(half.w, -1e-15);
    // Twice the half angle is the turn, counter-clockwise about the axis towards the viewer.
    EXPECT_NEAR(half.w * half.w - half.axis * half.axis, std::cos(turn * std::numbers::pi / 180),
                1e-12);
    EXPECT_NEAR(2 * half.w * half.axis, -std::sin(turn * std::numbers::pi / 180), 1e-12);
  }
}

TEST(BoardConfig, TagmintHasEveryTagsCorners) {
  for (const Board& board : {kalibr_board(), sample_bundle(), mixed_bundle()}) {
    const json file = json::parse(board_config(ConfigKind::Tagmint, board));
    EXPECT_EQ(file.at("format"), "tagmint-board");
    EXPECT_EQ(file.at("version"), 1);
    ASSERT_EQ(file.at("tags").size(), board.tags.size());
    for (std::size_t i = 0; i < board.tags.size(); ++i) {
      const BoardTag& tag = board.tags[i];
      const json& entry = file.at("tags").at(i);
      EXPECT_EQ(entry.at("family"), tag.family->name());
      EXPECT_EQ(entry.at("id"), tag.id);
      EXPECT_NEAR(entry.at("edge_m").get<double>(), tag.edge_mm / 1000, 1e-12);
      EXPECT_NEAR(entry.at("outer_m").get<double>(), outer_mm(tag) / 1000, 1e-12);
      const detect::Corners corners = border_corners(tag);
      ASSERT_EQ(entry.at("corners").size(), 4u);
      for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_NEAR(entry.at("corners").at(c).at(0).get<double>(), corners[c].x / 1000, 1e-12);
        EXPECT_NEAR(entry.at("corners").at(c).at(1).get<double>(), corners[c].y / 1000, 1e-12);
        EXPECT_EQ(entry.at("corners").at(c).at(2).get<double>(), 0);
      }
    }
  }
}

TEST(BoardConfig, TagmintTellsTheGridTheBorderAndTheHost) {
  const json kalibr = json::parse(board_config(ConfigKind::Tagmint, kalibr_board()));
  EXPECT_EQ(kalibr.at("family"), "tag36h11");
  EXPECT_EQ(kalibr.at("edge_m").get<double>(), 0.04);
  EXPECT_EQ(kalibr.at("grid").at("style"), "kalibr");
  EXPECT_EQ(kalibr.at("grid").at("spacing").get<double>(), 0.3);
  EXPECT_EQ(kalibr.at("grid").at("gap_m").get<double>(), 0.012);
  EXPECT_EQ(kalibr.at("tags").at(0).at("border_cells"), 2);
  const json mixed = json::parse(board_config(ConfigKind::Tagmint, mixed_bundle()));
  EXPECT_FALSE(mixed.contains("family"));
  EXPECT_FALSE(mixed.contains("edge_m"));
  EXPECT_EQ(mixed.at("tags").at(1).at("inside").at("family"), "tagCustom48h12");
  EXPECT_EQ(mixed.at("tags").at(1).at("inside").at("id"), 21);
  EXPECT_FALSE(mixed.at("tags").at(0).contains("inside"));
}

TEST(BoardConfig, WpilibStandsInThePlaneXIsZeroAndLooksAlongX) {
  const Board board = sample_grid("tag36h11", kPlain, 1);
  const json file = json::parse(board_config(ConfigKind::Wpilib, board));
  // 3 x 40 + 2 x 10 mm and a quiet cell of 5 mm on each side.
  EXPECT_NEAR(file.at("field").at("width").get<double>(), 0.150, 1e-12);
  EXPECT_GT(file.at("field").at("length").get<double>(), 0);
  const json& first = file.at("tags").at(0);  // the top left one
  EXPECT_EQ(first.at("ID"), 1);
  const json& translation = first.at("pose").at("translation");
  EXPECT_EQ(translation.at("x").get<double>(), 0);
  EXPECT_NEAR(translation.at("y").get<double>(), 0.025, 1e-12);
  EXPECT_NEAR(translation.at("z").get<double>(), 0.075, 1e-12);
  const json& quaternion = first.at("pose").at("rotation").at("quaternion");
  EXPECT_EQ(quaternion.at("W").get<double>(), 1);
  for (const char* axis : {"X", "Y", "Z"}) EXPECT_EQ(quaternion.at(axis).get<double>(), 0);
}

TEST(BoardConfig, KalibrIsRefusedForAllThatItImplies) {
  EXPECT_NE(board_config(ConfigKind::Kalibr, kalibr_board()), "");
  Grid grid = *kalibr_board().grid;
  expect_refusal(ConfigKind::Kalibr, sample_bundle(), "it describes grids only (--config)");
  expect_refusal(ConfigKind::Kalibr, sample_grid("tag36h11", grid, 1), "0, 1, 2, ... are meant");
  expect_refusal(ConfigKind::Kalibr, sample_grid("tag25h9", grid),
                 "tag36h11 is meant, not tag25h9");
  grid.border_cells = 1;
  expect_refusal(ConfigKind::Kalibr, sample_grid("tag36h11", grid), "two cells are meant, not 1");
  expect_refusal(ConfigKind::Kalibr, sample_grid("tag36h11", kPlain), "give --style kalibr");
}

TEST(BoardConfig, ProgramsThatKnowIdsAloneGetOneFamilyWithItsOwnBorder) {
  for (const ConfigKind kind : {ConfigKind::Ros1, ConfigKind::Ros2, ConfigKind::Wpilib}) {
    expect_refusal(kind, mixed_bundle(), "the board has tags of tagCustom48h12 and tag36h11");
    expect_refusal(kind, kalibr_board(), "give --border 1");
  }
  expect_refusal(ConfigKind::Wpilib, sample_bundle(), "a field layout of WPILib has no sizes");
  for (const ConfigKind kind : {ConfigKind::Ros2, ConfigKind::Wpilib}) {
    expect_refusal(kind, sample_grid("tag36h9", kPlain), "and tag36h9 is not in it");
  }
  EXPECT_EQ(refusal(ConfigKind::Ros1, sample_grid("tag36h9", kPlain)), "");
}

TEST(BoardConfig, KindsHaveNames) {
  EXPECT_EQ(name_of(ConfigKind::Kalibr), "kalibr");
  EXPECT_EQ(name_of(ConfigKind::Tagmint), "tagmint");
  EXPECT_EQ(config_kind_names().size(), 5u);
}

}  // namespace
}  // namespace tagmint::board
