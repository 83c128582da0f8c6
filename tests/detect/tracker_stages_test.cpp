// The tracker's stages one by one, on pictures small enough to read.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/start_kernels.h"
#include "support/fixed_random.h"
#include "support/paint_tags.h"
#include "tagmint/codec/layout_presets.h"
#include "tracker/bit_plane.h"
#include "tracker/t1_noise_floor.h"
#include "tracker/t2_bitmap.h"
#include "tracker/t4_track.h"
#include "tracker/t5_corners.h"
#include "tracker/t6_edges.h"

namespace tagmint::detect {
namespace {

using testing::Canvas;
using testing::FixedRandom;
using Rows = std::vector<std::string_view>;

/// '#' is black.
BitPlane plane_of(const Rows& rows) {
  BitPlane plane;
  plane.resize(static_cast<int>(rows.at(0).size()), static_cast<int>(rows.size()));
  for (int y = 0; y < plane.height(); ++y) {
    std::fill_n(plane.row(y), plane.words(), 0);
    for (int x = 0; x < plane.width(); ++x) {
      if (rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#') {
        plane.row(y)[x / 64] |= std::uint64_t{1} << (x % 64);
      }
    }
  }
  return plane;
}

// T1

TEST(NoiseFloor, TellsTheNoiseOfAFlatPicture) {
  for (const double sigma : {1.0, 2.0, 5.0, 10.0, 20.0}) {
    FixedRandom random(3);
    const Image image = testing::to_gray(Canvas(640, 480, 128), sigma, random);
    EXPECT_NEAR(estimate_noise(image), sigma, 0.12 * sigma + 0.1) << sigma;
  }
}

TEST(NoiseFloor, LightThatFallsOffIsNoNoise) {
  Canvas canvas(640, 480, 0);
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) canvas.at(x, y) = 20 + 0.3f * static_cast<float>(x);
  }
  FixedRandom random(3);
  EXPECT_LT(estimate_noise(testing::to_gray(canvas, 0, random)), 0.5);
  EXPECT_NEAR(estimate_noise(testing::to_gray(canvas, 4, random)), 4, 0.6);
}

TEST(NoiseFloor, PicturesThatSayNothingHaveNone) {
  EXPECT_EQ(estimate_noise(Image(640, 480, 255)), 0);  // at the sensor's limit
  EXPECT_EQ(estimate_noise(Image(20, 20, 100)), 0);    // too narrow
  EXPECT_EQ(estimate_noise(Image(1, 1, 100)), 0);
}

TEST(NoiseFloor, IsSevenDeviationsWithinItsBounds) {
  EXPECT_EQ(contrast_floor(0, 5, 255), 5);
  EXPECT_EQ(contrast_floor(4, 5, 255), 31);
  EXPECT_EQ(contrast_floor(100, 5, 255), 255);
}

// T2

/// The picture's bits, a band of rows at a time.
std::vector<std::string> bits_of(ImageView image, int rows_at_once, bool white) {
  BitPlane black, whites;
  black.resize(image.width, image.height);
  whites.resize(image.width, image.height);
  BitmapScratch scratch;
  for (int y = 0; y < image.height; y += rows_at_once) {
    threshold_rows(image, y, std::min(y + rows_at_once, image.height), {10, 255}, scratch, black,
                   &whites);
  }
  std::vector<std::string> rows;
  for (int y = 0; y < image.height; ++y) {
    std::string& row = rows.emplace_back();
    for (int x = 0; x < image.width; ++x) row += (white ? whites : black).at(x, y) ? '#' : '.';
  }
  return rows;
}

TEST(Bitmap, IsBlackBelowTheMiddleOfItsNeighbourhoodAndNothingWithoutContrast) {
  Image image(24, 16, 200);
  for (int y = 4; y < 8; ++y) {
    for (int x = 4; x < 7; ++x) image.at(x, y) = 100;
  }
  const std::vector<std::string> black = bits_of(image, 16, false);
  const std::vector<std::string> white = bits_of(image, 16, true);
  EXPECT_EQ(black[3], "........................");
  EXPECT_EQ(black[4], "....###.................");
  EXPECT_EQ(black[7], "....###.................");
  EXPECT_EQ(black[8], "........................");
  // Tiles next to the one with the black pixels know of it, others do not.
  EXPECT_EQ(white[0], "############............");
  EXPECT_EQ(white[4], "####...#####............");
  EXPECT_EQ(white[11], "############............");
  EXPECT_EQ(white[12], "........................");
}

TEST(Bitmap, DoesNotDependOnTheBandsItIsMadeIn) {
  FixedRandom random(2);
  for (const int width : {1, 5, 63, 130}) {
    for (const int height : {1, 3, 4, 13, 64, 67}) {
      Image image(width, height);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          image.at(x, y) = static_cast<std::uint8_t>(random.between(0, 255));
        }
      }
      const auto whole = bits_of(image, 1024, false);
      EXPECT_EQ(bits_of(image, 4, false), whole) << width << " x " << height;
      EXPECT_EQ(bits_of(image, 8, false), whole) << width << " x " << height;
    }
  }
}

// T3

/// Ends of the starts in each row.
std::vector<std::pair<int, int>> starts_of(const BitPlane& plane) {
  std::vector<std::uint64_t> bits(static_cast<std::size_t>(plane.height()) * kBitVectorWords);
  find_starts({plane.row(0), static_cast<std::ptrdiff_t>(plane.stride())}, plane.height(),
              plane.words(), bits.data(), kBitVectorWords);
  std::vector<std::pair<int, int>> starts;
  for (int y = 0; y < plane.height(); ++y) {
    for (int x = 0; x < plane.width(); ++x) {
      if (bits[static_cast<std::size_t>(y * kBitVectorWords + x / 64)] >> (x % 64) & 1) {
        starts.emplace_back(x, y);
      }
    }
  }
  return starts;
}

TEST(Starts, AreTopRunsWithAPathDown) {
  const BitPlane plane = plane_of({
      "............................",  // Only the first shape begins on a run of its own and goes
      "..####......##....##........",  // down five rows: the second and the third are too low, and
      "..####......##....##........",  // of the last one only diagonal steps hold together.
      "..##########......##..#.....",
      "..##########......##..#.....",
      "..####..####.........#......",
      "..##....####.........#......",
      "............................",
  });
  using Starts = std::vector<std::pair<int, int>>;
  EXPECT_EQ(starts_of(plane), (Starts{{5, 1}}));
}

TEST(Starts, EveryShapeOfAPixelGridIsFound) {
  // A square turned any way begins on exactly one run with nothing above it.
  for (int degrees = 0; degrees < 90; degrees += 7) {
    Canvas canvas(60, 60, 200);
    const codec::SharedFamily family =
        testing::random_family("square", codec::classic_layout(8), 5, 2);
    testing::paint_tag(canvas, *family, 0,
                       testing::square_at({30, 30}, 24, degrees * std::numbers::pi / 180));
    FixedRandom random(1);
    const Image image = testing::to_gray(canvas, 0, random);
    BitPlane black;
    black.resize(60, 60);
    BitmapScratch scratch;
    threshold_rows(image, 0, 60, {100, 255}, scratch, black, nullptr);
    EXPECT_GE(starts_of(black).size(), 1u) << degrees;
  }
}

// T4 and T5

struct Tracked {
  TrackOutcome outcome;
  Shape shape;
};

Tracked track(const BitPlane& plane, int x, int y) {
  Tracked tracked;
  tracked.shape.left.resize(static_cast<std::size_t>(plane.height()));
  tracked.shape.right.resize(static_cast<std::size_t>(plane.height()));
  VisitedBand visited;
  visited.reset(0, plane.height(), plane.width());
  tracked.outcome = track_shape(plane, x, y, visited, tracked.shape);
  return tracked;
}

const Rows kDiamond = {
    "..............", "......##......", ".....####.....", "....##..##....",
    "...##....##...", "..##......##..", "...##....##...", "....##..##....",
    ".....####.....", "......##......", "..............",
};

TEST(Track, FollowsTheOutermostPixelsPastWhiteInside) {
  const auto [outcome, shape] = track(plane_of(kDiamond), 6, 1);
  ASSERT_EQ(outcome, TrackOutcome::Done);
  EXPECT_EQ(shape.top, 1);
  EXPECT_EQ(shape.height, 9);
  EXPECT_EQ(shape.left_most, 2);
  EXPECT_EQ(shape.right_most, 11);
  const std::vector<std::int32_t> left(shape.left.begin(), shape.left.begin() + 9);
  const std::vector<std::int32_t> right(shape.right.begin(), shape.right.begin() + 9);
  EXPECT_EQ(left, (std::vector<std::int32_t>{6, 5, 4, 3, 2, 3, 4, 5, 6}));
  EXPECT_EQ(right, (std::vector<std::int32_t>{7, 8, 9, 10, 11, 10, 9, 8, 7}));
  EXPECT_EQ(shape.area, 2 + 4 + 6 + 8 + 10 + 8 + 6 + 4 + 2);
}

TEST(Track, BeginsOnlyWhereNothingIsAbove) {
  EXPECT_EQ(track(plane_of(kDiamond), 5, 2).outcome, TrackOutcome::Covered);
}

TEST(Track, NoShapeIsFollowedTwice) {
  const BitPlane plane = plane_of({"#...#", "#...#", "#####", "#####", "#####"});
  Shape shape;
  shape.left.resize(5);
  shape.right.resize(5);
  VisitedBand visited;
  visited.reset(0, 5, 5);
  EXPECT_EQ(track_shape(plane, 0, 0, visited, shape), TrackOutcome::Done);
  EXPECT_EQ(track_shape(plane, 4, 0, visited, shape), TrackOutcome::Visited);
}

TEST(Track, LeavesShapesThatGoApartAgain) {
  Rows rows;
  for (int i = 0; i < 12; ++i) rows.push_back("######################");
  for (int i = 0; i < 12; ++i) rows.push_back("........######........");
  for (int i = 0; i < 12; ++i) rows.push_back("######################");
  EXPECT_EQ(track(plane_of(rows), 3, 0).outcome, TrackOutcome::NotConvex);
}

TEST(Track, LongRunsAndPictureEdgesAreNoMatter) {
  const std::string full(300, '#');
  const BitPlane plane = plane_of(Rows(200, full));
  const auto [outcome, shape] = track(plane, 150, 0);
  ASSERT_EQ(outcome, TrackOutcome::Done);
  EXPECT_EQ(shape.height, 200);
  EXPECT_EQ(shape.left_most, 0);
  EXPECT_EQ(shape.right_most, 299);
  EXPECT_EQ(shape.area, 300 * 200);
}

CornerResult corners_of_shape(const Shape& shape) {
  OutlineScratch scratch;
  return find_corners(shape, {.min_side_px = 4}, scratch);
}

/// A filled convex polygon, as the tracker would have followed it.
Shape filled(const Corners& corners, int size) {
  Shape shape;
  shape.left_most = size;
  shape.right_most = 0;
  for (int y = 0; y < size; ++y) {
    int first = size, last = -1;
    for (int x = 0; x < size; ++x) {
      bool inside = true;
      for (std::size_t i = 0; i < 4; ++i) {
        inside = inside && cross(corners[(i + 1) % 4] - corners[i],
                                 Point{x + 0.5, y + 0.5} - corners[i]) <= 0;
      }
      if (!inside) continue;
      first = std::min(first, x);
      last = std::max(last, x);
    }
    if (last < 0) continue;
    if (shape.height == 0) shape.top = y;
    ++shape.height;
    shape.left.push_back(first);
    shape.right.push_back(last);
    shape.left_most = std::min(shape.left_most, first);
    shape.right_most = std::max(shape.right_most, last);
    shape.area += last - first + 1;
  }
  return shape;
}

/// Largest distance of found corners from the true ones, whichever comes first.
double largest_error(const Corners& found, const Corners& truth) {
  double best = 1e9;
  for (std::size_t first = 0; first < 4; ++first) {
    double largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      largest = std::max(largest, length(found[(i + first) % 4] - truth[i]));
    }
    best = std::min(best, largest);
  }
  return best;
}

TEST(Corners, AreThoseOfQuadsOfAnyTurnAndTilt) {
  FixedRandom random(11);
  for (int i = 0; i < 60; ++i) {
    const Corners truth = testing::corners_of(
        testing::tilted_square_at({200, 200}, random.real(40, 200), random.real(0, 6.28),
                                  random.real(0, 1.2), random.real(0, 6.28), 4));
    const CornerResult result = corners_of_shape(filled(truth, 400));
    ASSERT_TRUE(result.corners) << i << ": " << static_cast<int>(result.refused);
    EXPECT_LT(signed_area(*result.corners), 0);
    EXPECT_LT(largest_error(*result.corners, truth), 2.6) << i;
  }
}

TEST(Corners, OfHighShapesAreFoundInTheRowsLeftOut) {
  const Corners truth = {{{300, 1890}, {1700, 1500}, {1650, 120}, {350, 300}}};
  const CornerResult result = corners_of_shape(filled(truth, 2000));
  ASSERT_TRUE(result.corners);
  EXPECT_LT(largest_error(*result.corners, truth), 2.0);
}

TEST(Corners, OtherShapesHaveNone) {
  const auto shape_of = [](const Rows& rows, int x) { return track(plane_of(rows), x, 0).shape; };
  // A triangle, a disc, a low bar, and a house.
  const Rows triangle = {"......#......", ".....###.....", ".....###.....", "....#####....",
                         "....#####....", "...#######...", "...#######...", "..#########..",
                         "..#########..", ".###########.", ".###########.", "#############"};
  EXPECT_FALSE(corners_of_shape(shape_of(triangle, 6)).corners);
  std::vector<std::string> disc(41, std::string(41, '.'));
  for (int y = 0; y < 41; ++y) {
    for (int x = 0; x < 41; ++x) {
      if ((x - 20) * (x - 20) + (y - 20) * (y - 20) <= 400) {
        disc[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = '#';
      }
    }
  }
  EXPECT_FALSE(corners_of_shape(shape_of(Rows(disc.begin(), disc.end()), 20)).corners);
  EXPECT_EQ(corners_of_shape(shape_of({"##########", "##########"}, 3)).refused,
            CornerOutcome::TooSmall);
}

// T6

TEST(Edges, FollowTheGrayValuesToAFractionOfAPixel) {
  FixedRandom random(5);
  const codec::SharedFamily family =
      testing::random_family("edges", codec::classic_layout(8), 5, 2);
  double sum = 0;
  int quads = 0;
  for (int i = 0; i < 60; ++i) {
    Canvas canvas(120, 120, 200);
    const Homography truth =
        testing::tilted_square_at({random.real(55, 65), random.real(55, 65)}, random.real(20, 60),
                                  random.real(0, 6.28), random.real(0, 1.0), random.real(0, 6.28));
    testing::paint_tag(canvas, *family, 0, truth);
    testing::blur(canvas, 0.6);
    const Image image = testing::to_gray(canvas, 1, random);
    Quad start{testing::corners_of(truth), false};
    for (Point& corner : start.corners) {
      corner = corner + Point{random.real(-1, 1), random.real(-1, 1)};
    }
    const std::optional<Quad> fitted = fit_edges(image, start, {.min_side_px = 4});
    ASSERT_TRUE(fitted) << i;
    const double error = largest_error(fitted->corners, testing::corners_of(truth));
    EXPECT_LT(error, 0.5) << i;
    sum += error;
    ++quads;
  }
  EXPECT_LT(sum / quads, 0.12);  // the worst of four corners, noise 1
}

TEST(Edges, OfTheOtherColourAreNone) {
  const codec::SharedFamily family =
      testing::random_family("edges", codec::classic_layout(8), 5, 2);
  Canvas canvas(100, 100, 200);
  const Homography truth = testing::square_at({50, 50}, 40, 0.2);
  testing::paint_tag(canvas, *family, 0, truth);
  FixedRandom random(1);
  const Image image = testing::to_gray(canvas, 0, random);
  const Quad black{testing::corners_of(truth), false}, white{testing::corners_of(truth), true};
  EXPECT_TRUE(fit_edges(image, black, {.min_side_px = 4}));
  EXPECT_FALSE(fit_edges(image, white, {.min_side_px = 4}));
  EXPECT_FALSE(fit_edges(Image(100, 100, 128), black, {.min_side_px = 4}));
}

}  // namespace
}  // namespace tagmint::detect
