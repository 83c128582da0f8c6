#include "board/bundle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "tagmint/codec/builtin_families.h"

namespace tagmint::board {
namespace {

using codec::find_family;

BoardTag tag(const std::string& family, codec::TagId id, double edge, double x, double y,
             double turn = 0) {
  return make_tag(find_family(family), id, edge, {x, y}, turn);
}

std::string refusal(std::vector<BoardTag> tags) {
  try {
    plan_bundle(std::move(tags));
  } catch (const draw::DoesNotFit& fault) {
    return fault.what();
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "";
}

TEST(Bundle, KeepsPlacesAndHoldsAllQuietZones) {
  const Board board = plan_bundle({tag("tag36h11", 0, 80, 0, 0), tag("tag16h5", 1, 30, 100, -20)});
  EXPECT_DOUBLE_EQ(board.tags[1].centre_mm.x, 100);
  // 100 mm of the first around the origin; 40 mm of the second around its place.
  EXPECT_DOUBLE_EQ(board.extent.x_mm, -50);
  EXPECT_DOUBLE_EQ(board.extent.right_mm(), 120);
  EXPECT_DOUBLE_EQ(board.extent.y_mm, -50);
  EXPECT_DOUBLE_EQ(board.extent.bottom_mm(), 50);
  EXPECT_FALSE(board.grid.has_value());
}

TEST(Bundle, TurnsClockwiseAsSeen) {
  const Board board = plan_bundle({tag("tag36h11", 0, 80, 10, 20, 90)});
  const detect::Corners corners = border_corners(board.tags[0]);
  // What was at the bottom left is at the top left after a quarter turn clockwise; exactly so.
  EXPECT_EQ(corners[0], (detect::Point{-30, -20}));
  EXPECT_EQ(corners[1], (detect::Point{-30, 60}));
  EXPECT_EQ(corners[2], (detect::Point{50, 60}));
  EXPECT_EQ(corners[3], (detect::Point{50, -20}));
  const detect::Corners tilted = border_corners(tag("tag36h11", 0, 80, 0, 0, -45));
  EXPECT_NEAR(tilted[0].x, 0, 1e-9);
  EXPECT_NEAR(tilted[0].y, 40 * std::sqrt(2.0), 1e-9);
}

TEST(Bundle, ExtentOfATurnedTagReachesToItsCorners) {
  const Board board = plan_bundle({tag("tag36h11", 0, 80, 0, 0, 45)});
  EXPECT_NEAR(board.extent.width_mm, 100 * std::sqrt(2.0), 1e-9);
}

TEST(Bundle, NeighboursMayShareQuietZonesButNotReachIntoThem) {
  // Border squares 80 mm wide with white rings of 10 mm: 90 mm apart is just enough.
  EXPECT_EQ(refusal({tag("tag36h11", 0, 80, 0, 0), tag("tag36h11", 1, 80, 90, 0)}), "");
  EXPECT_EQ(refusal({tag("tag36h11", 0, 80, 0, 0), tag("tag36h11", 1, 80, 89.9, 0)}),
            "tag36h11 0 at 0 mm, 0 mm and tag36h11 1 at 89.9 mm, 0 mm stand too near: one reaches "
            "into the quiet zone of the other; move them apart or make one of them smaller");
  // Beside a turned one, the corner counts: 40 sqrt(2) + 50 mm.
  EXPECT_EQ(refusal({tag("tag36h11", 0, 80, 0, 0), tag("tag36h11", 1, 80, 110.8, 0, 45)}), "");
  EXPECT_NE(refusal({tag("tag36h11", 0, 80, 0, 0), tag("tag36h11", 1, 80, 106, 0, 45)}), "");
}

TEST(Bundle, ATagInAHoleHasAHost) {
  // The hole of a 48h12 tag with cells of 30 mm has 60 mm: an edge of 48 mm fills it.
  const Board board =
      plan_bundle({tag("tag36h11", 5, 48, 200, 0, 30), tag("tagCustom48h12", 1, 180, 200, 0, 30),
                   tag("tag16h5", 2, 60, -120, 0)});
  EXPECT_EQ(board.tags[0].host, 1u);
  EXPECT_EQ(board.tags[1].host, std::nullopt);
  EXPECT_EQ(board.tags[2].host, std::nullopt);
  EXPECT_NE(refusal({tag("tag36h11", 5, 48.1, 0, 0), tag("tagCustom48h12", 1, 180, 0, 0)}), "");
}

TEST(Bundle, TheSmallestHoleIsTheHost) {
  const Board board = plan_bundle({tag("tagCustom48h12", 1, 600, 0, 0), tag("tag16h5", 2, 10, 0, 0),
                                   tag("tagCustom48h12", 3, 90, 0, 0)});
  EXPECT_EQ(board.tags[1].host, 2u);
  EXPECT_EQ(board.tags[2].host, 0u);
}

TEST(Bundle, ImpossibleBundlesAreRefused) {
  EXPECT_EQ(refusal({}), "a board needs at least one tag");
  EXPECT_EQ(refusal({tag("tag36h11", 7, 80, 0, 0), tag("tag36h11", 7, 40, 300, 0)}),
            "tag 7 of tag36h11 would stand on the board twice; give each place an id of its own");
  EXPECT_NE(refusal({tag("tag36h11", 587, 80, 0, 0)}), "");
  EXPECT_NE(refusal({tag("tag36h11", 0, 0, 0, 0)}), "");
  EXPECT_NE(refusal({tag("tag36h11", 0, 80, NAN, 0)}), "");
}

}  // namespace
}  // namespace tagmint::board
