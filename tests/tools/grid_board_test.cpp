#include "board/grid_board.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "board/clearance.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::board {
namespace {

using codec::find_family;
using codec::TagId;

std::vector<TagId> ids_from(TagId first, std::size_t count) {
  std::vector<TagId> ids(count);
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

Board grid_of(const std::string& family, const Grid& grid, TagId first = 0) {
  return plan_grid(find_family(family), grid,
                   ids_from(first, static_cast<std::size_t>(grid.columns) * grid.rows));
}

const BoardTag& tag_of(const Board& board, TagId id) {
  for (const BoardTag& tag : board.tags) {
    if (tag.id == id) return tag;
  }
  throw std::runtime_error("no such tag on the board");
}

void expect_point(detect::Point p, double x, double y) {
  EXPECT_NEAR(p.x, x, 1e-9);
  EXPECT_NEAR(p.y, y, 1e-9);
}

constexpr Grid kPlain = {.columns = 3, .rows = 2, .edge_mm = 80, .gap_mm = 20};
constexpr Grid kKalibr = {.columns = 3,
                          .rows = 2,
                          .edge_mm = 100,
                          .gap_mm = 30,
                          .style = Style::Kalibr,
                          .border_cells = 2};

TEST(GridBoard, PlainIdsRunFromTheTopLeftRowByRow) {
  const Board board = grid_of("tag36h11", kPlain, 10);
  ASSERT_EQ(board.tags.size(), 6u);
  expect_point(tag_of(board, 10).centre_mm, -100, -50);
  expect_point(tag_of(board, 11).centre_mm, 0, -50);
  expect_point(tag_of(board, 13).centre_mm, -100, 50);
  expect_point(tag_of(board, 15).centre_mm, 100, 50);
  EXPECT_TRUE(board.squares.empty());
}

TEST(GridBoard, PlainBoardIsTheTagsWithTheirQuietZones) {
  const Board board = grid_of("tag36h11", kPlain);
  // A cell of 10 mm is white around each border square: 280 + 2 x 10 by 180 + 2 x 10 mm.
  EXPECT_NEAR(board.extent.width_mm, 300, 1e-9);
  EXPECT_NEAR(board.extent.height_mm, 200, 1e-9);
  expect_point({board.extent.x_mm, board.extent.y_mm}, -150, -100);
}

TEST(GridBoard, KalibrIdsRunFromTheBottomLeftRowByRow) {
  const Board board = grid_of("tag36h11", kKalibr);
  expect_point(tag_of(board, 0).centre_mm, -130, 65);
  expect_point(tag_of(board, 2).centre_mm, 130, 65);
  expect_point(tag_of(board, 3).centre_mm, -130, -65);
  expect_point(tag_of(board, 5).centre_mm, 130, -65);
}

TEST(GridBoard, KalibrSquaresTouchAllCornersOfTheBorderSquares) {
  const Board board = grid_of("tag36h11", kKalibr);
  ASSERT_EQ(board.squares.size(), 12u);  // 4 x 3
  int touched = 0;
  for (const BoardTag& tag : board.tags) {
    for (const detect::Point corner : border_corners(tag)) {
      for (const draw::Box& square : board.squares) {
        for (const double x : {square.x_mm, square.right_mm()}) {
          for (const double y : {square.y_mm, square.bottom_mm()}) {
            if (std::hypot(x - corner.x, y - corner.y) < 1e-9) ++touched;
          }
        }
      }
    }
  }
  EXPECT_EQ(touched, 24);  // four corners of six tags, one square each
  EXPECT_NEAR(board.extent.width_mm, 3 * 100 + 4 * 30, 1e-9);
  EXPECT_NEAR(board.extent.height_mm, 2 * 100 + 3 * 30, 1e-9);
}

TEST(GridBoard, KalibrBorderIsTwoCellsAndTheSameBits) {
  const Board board = grid_of("tag36h11", kKalibr);
  const codec::Layout& layout = board.tags[0].layout;
  EXPECT_EQ(layout.width(), 12);
  EXPECT_EQ(layout.width_at_border(), 10);
  const codec::TagCells wide = cells_of(board.tags[3]);
  const codec::TagCells own =
      codec::tag_cells(find_family("tag36h11")->layout(), find_family("tag36h11")->codeword(3));
  for (int y = 1; y < 9; ++y) {
    for (int x = 1; x < 9; ++x) EXPECT_EQ(wide.at(x + 1, y + 1), own.at(x, y));
  }
  for (int i = 1; i < 11; ++i) {
    EXPECT_EQ(wide.at(i, 1), codec::Cell::Black);
    EXPECT_EQ(wide.at(i, 0), codec::Cell::White);
  }
  EXPECT_NEAR(outer_mm(board.tags[0]), 120, 1e-9);
}

TEST(GridBoard, CornersAreInTheOrderOfTheConventions) {
  const Board board = grid_of("tag36h11", kPlain);
  const detect::Corners corners = border_corners(tag_of(board, 0));
  expect_point(corners[0], -140, -10);  // bottom left
  expect_point(corners[1], -60, -10);   // bottom right
  expect_point(corners[2], -60, -90);   // top right
  expect_point(corners[3], -140, -90);  // top left
}

TEST(GridBoard, NestedTagsCountUpWithTheirHosts) {
  const std::vector<draw::NestedRequest> nested = {{find_family("tag36h11"), 20, {}}};
  const Grid grid = {.columns = 2, .rows = 1, .edge_mm = 60, .gap_mm = 60};
  const Board board =
      plan_grid(find_family("tagCustom48h12"), grid, std::vector<TagId>{4, 5}, nested);
  ASSERT_EQ(board.tags.size(), 4u);
  EXPECT_EQ(board.tags[1].id, 20u);
  EXPECT_EQ(board.tags[3].id, 21u);
  EXPECT_EQ(board.tags[3].host, 2u);
  EXPECT_DOUBLE_EQ(board.tags[3].edge_mm, 16);
  expect_point(board.tags[3].centre_mm, 60, 0);
}

TEST(GridBoard, LeastGapKeepsBlackOutOfQuietZones) {
  EXPECT_DOUBLE_EQ(least_gap_mm(codec::classic_layout(10), 80), 10);
  // Two cells outside each border square, and a white one between them.
  EXPECT_DOUBLE_EQ(least_gap_mm(codec::standard_layout(9), 50), 50);
  const Grid narrow = {.columns = 2, .rows = 1, .edge_mm = 50, .gap_mm = 49.9};
  try {
    grid_of("tagStandard41h12", narrow);
    FAIL();
  } catch (const draw::DoesNotFit& fault) {
    EXPECT_EQ(std::string(fault.what()),
              "a gap of 49.9 mm between border squares is too narrow: one tag would reach into the "
              "quiet zone of the next (tagStandard41h12 with edge 50 mm); give at least --spacing "
              "1 or 50mm");
  }
  EXPECT_NO_THROW(
      grid_of("tagStandard41h12", {.columns = 2, .rows = 1, .edge_mm = 50, .gap_mm = 50}));
}

TEST(GridBoard, ImpossibleGridsAreRefused) {
  const auto family = find_family("tag16h5");
  const auto refused = [&](const Grid& grid, std::vector<TagId> ids) {
    EXPECT_THROW(plan_grid(family, grid, ids), std::invalid_argument);
  };
  refused({.columns = 0, .rows = 3, .edge_mm = 40, .gap_mm = 20}, {});
  refused({.columns = 2, .rows = 1, .edge_mm = 40, .gap_mm = -1}, {0, 1});
  refused({.columns = 2, .rows = 1, .edge_mm = 0, .gap_mm = 20}, {0, 1});
  refused({.columns = 2, .rows = 1, .edge_mm = 40, .gap_mm = 20}, {0});
  refused({.columns = 2, .rows = 1, .edge_mm = 40, .gap_mm = 20}, {0, 30});
  refused({.columns = 2, .rows = 1, .edge_mm = 40, .gap_mm = 20}, {4, 4});
  const Grid kalibr = {
      .columns = 1, .rows = 1, .edge_mm = 40, .gap_mm = 90, .style = Style::Kalibr};
  EXPECT_THROW(grid_of("tagStandard41h12", kalibr), std::invalid_argument);
  const Grid wide = {.columns = 1, .rows = 1, .edge_mm = 40, .gap_mm = 90, .border_cells = 2};
  EXPECT_THROW(grid_of("tagStandard41h12", wide), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::board
