#include "scene/coverage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scene/counter_random.h"

namespace tagmint::scene {
namespace {

using detect::Point;
using Polygon = std::vector<Point>;

/// The coverage of every pixel of a width x height image, row-major.
std::vector<double> pixels_of(const Coverage& coverage, int width, int height) {
  std::vector<double> pixels(static_cast<std::size_t>(width) * height, 0.0);
  for (int y = 0; y < height; ++y) {
    Coverage::Row row = coverage.row(y);
    for (int x = 0; x < width; ++x) pixels[static_cast<std::size_t>(y) * width + x] = row.next();
  }
  return pixels;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

TEST(Coverage, IsTheCoveredShareOfEachPixel) {
  Coverage coverage(4, 3);
  coverage.add(Polygon{{0.5, 0.25}, {2.25, 0.25}, {2.25, 2}, {0.5, 2}});
  const std::vector<double> expected = {0.375, 0.75, 0.1875, 0,  //
                                        0.5,   1,    0.25,   0,  //
                                        0,     0,    0,      0};
  const std::vector<double> found = pixels_of(coverage, 4, 3);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-14) << i;
  EXPECT_DOUBLE_EQ(coverage.total_area(), 1.75 * 1.75);
}

TEST(Coverage, OfADiagonalIsHalfOfThePixelsOnIt) {
  Coverage coverage(5, 5);
  coverage.add(Polygon{{0, 0}, {5, 5}, {0, 5}});
  const std::vector<double> found = pixels_of(coverage, 5, 5);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      EXPECT_NEAR(found[y * 5 + x], x < y ? 1 : x == y ? 0.5 : 0, 1e-14) << x << ' ' << y;
    }
  }
}

TEST(Coverage, SumsUpToThePolygonsArea) {
  RandomStream random(5);
  for (int i = 0; i < 300; ++i) {
    Polygon triangle;
    for (int k = 0; k < 3; ++k) triangle.push_back({random.uniform(0, 40), random.uniform(0, 30)});
    if (cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) < 0) {
      std::swap(triangle[1], triangle[2]);
    }
    Coverage coverage(40, 30);
    coverage.add(triangle);
    EXPECT_NEAR(sum(pixels_of(coverage, 40, 30)), coverage.total_area(), 1e-10);
  }
}

TEST(Coverage, AgreesWithManySamplesAPixel) {
  const Polygon quad = {{2.3, 1.1}, {9.7, 3.4}, {7.9, 8.8}, {0.6, 6.2}};
  Coverage coverage(10, 10);
  coverage.add(quad);
  const std::vector<double> found = pixels_of(coverage, 10, 10);
  constexpr int kSide = 200;  // samples a pixel side; the error is about 1 / side
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 10; ++x) {
      int inside = 0;
      for (int i = 0; i < kSide * kSide; ++i) {
        const Point p{x + (i % kSide + 0.5) / kSide, y + (i / kSide + 0.5) / kSide};
        bool in = true;
        for (int k = 0; k < 4; ++k) in &= cross(quad[(k + 1) % 4] - quad[k], p - quad[k]) >= 0;
        inside += in;
      }
      EXPECT_NEAR(found[y * 10 + x], inside / double(kSide * kSide), 0.005) << x << ' ' << y;
    }
  }
}

TEST(Coverage, OfPolygonsSideBySideHasNoSeam) {
  // A fan of slivers around an odd centre fills the square.
  Coverage coverage(16, 16);
  const Point centre{7.123, 8.877};
  constexpr int kSlivers = 97;
  const auto rim = [](int i) -> Point {
    const double s = 4.0 * (i % kSlivers) / kSlivers;  // once around the square, clockwise
    if (s < 1) return {16 * s, 0};
    if (s < 2) return {16, 16 * (s - 1)};
    if (s < 3) return {16 * (3 - s), 16};
    return {0, 16 * (4 - s)};
  };
  const std::vector<Point> corners = {{16, 0}, {16, 16}, {0, 16}, {0, 0}};
  for (int i = 0; i < kSlivers; ++i) {
    Polygon sliver = {centre, rim(i)};
    const int side = 4 * i / kSlivers;
    if (4 * (i + 1) / kSlivers != side && i + 1 < kSlivers) sliver.push_back(corners[side]);
    sliver.push_back(rim(i + 1));
    coverage.add(sliver);
  }
  for (const double share : pixels_of(coverage, 16, 16)) EXPECT_NEAR(share, 1, 1e-12);
}

TEST(Coverage, CutsOffWhatIsOutsideTheImage) {
  Coverage coverage(6, 4);
  coverage.add(Polygon{{-1e7, -1e6}, {1e7, -1e6}, {1e7, 1e6}, {-1e7, 1e6}});
  for (const double share : pixels_of(coverage, 6, 4)) EXPECT_NEAR(share, 1, 1e-9);
  coverage.reset(6, 4);
  for (const Point shift : {Point{-20, 0}, Point{20, 0}, Point{0, -20}, Point{0, 20}}) {
    coverage.add(Polygon{shift, shift + Point{3, 1}, shift + Point{3, 3}, shift + Point{0, 3}});
  }
  for (const double share : pixels_of(coverage, 6, 4)) EXPECT_NEAR(share, 0, 1e-12);
  coverage.reset(6, 4);
  coverage.add(Polygon{{-2, 2}, {3, -3}, {8, 2}, {3, 7}});  // a diamond over all four sides
  double expected = 0;
  for (int i = 0; i < 6 * 1000; ++i) {
    const double x = (i + 0.5) / 1000;
    const double reach = 5 - std::abs(x - 3);
    expected += (std::min(4.0, 2 + reach) - std::max(0.0, 2 - reach)) / 1000;
  }
  EXPECT_NEAR(sum(pixels_of(coverage, 6, 4)), expected, 1e-5);
}

TEST(Coverage, BoxHoldsTheTouchedPixelsOfTheImage) {
  const PixelBox box = box_of(Polygon{{-3, 1.5}, {2.25, 1}, {4, 9}}, 6, 4);
  EXPECT_EQ(box.x0, 0);
  EXPECT_EQ(box.y0, 1);
  EXPECT_EQ(box.x1, 4);
  EXPECT_EQ(box.y1, 4);
  EXPECT_TRUE(box_of(Polygon{{-3, 1}, {-1, 2}}, 6, 4).empty());
  EXPECT_TRUE(box_of(Polygon{}, 6, 4).empty());
}

}  // namespace
}  // namespace tagmint::scene
