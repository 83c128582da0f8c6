#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "numerics/bilinear.h"
#include "numerics/gray_model.h"
#include "numerics/polygon_overlap.h"
#include "numerics/polynomial_roots.h"
#include "numerics/small_matrix.h"
#include "support/fixed_random.h"
#include "tagmint/detect/image.h"

namespace tagmint::detect {
namespace {

TEST(SmallMatrix, InverseTimesMatrixIsTheIdentity) {
  testing::FixedRandom random(3);
  for (int trial = 0; trial < 100; ++trial) {
    Matrix3 a;
    for (double& value : a) value = random.real(-1, 1);
    const auto inverted = inverse(a);
    ASSERT_TRUE(inverted);
    const Matrix3 product = multiply(*inverted, a);
    for (int i = 0; i < 9; ++i) EXPECT_NEAR(product[i], i % 4 == 0 ? 1.0 : 0.0, 1e-9);
  }
}

TEST(SmallMatrix, SolveUndoesMultiply) {
  const Matrix3 a = {2, -1, 0.5, 3, 4, -2, 1, 1, 7};
  const Vector3 x = {1, -2, 3};
  const auto solved = solve(a, multiply(a, x));
  ASSERT_TRUE(solved);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR((*solved)[i], x[i], 1e-12);
}

TEST(SmallMatrix, SingularIsJudgedWithoutRegardToScale) {
  EXPECT_FALSE(inverse({1, 2, 3, 2, 4, 6, 1, 0, 1}));
  EXPECT_FALSE(inverse({0, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_TRUE(inverse({1e-9, 0, 0, 0, 1e-9, 0, 0, 0, 1e-9}));
}

TEST(Bilinear, PixelCentresHaveTheirOwnValue) {
  Image image(3, 2);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) image.at(x, y) = static_cast<std::uint8_t>(10 * x + 100 * y);
  }
  EXPECT_EQ(sample_bilinear(image, {0.5, 0.5}), 0.0);
  EXPECT_EQ(sample_bilinear(image, {2.5, 1.5}), 120.0);
  EXPECT_EQ(sample_bilinear(image, {1.0, 1.0}), 55.0);
}

TEST(Bilinear, TheOutermostPixelsGoOnToTheImageEdgeAndNoFarther) {
  Image image(2, 2, 50);
  image.at(1, 1) = 90;
  EXPECT_EQ(sample_bilinear(image, {2.0, 2.0}), 90.0);
  EXPECT_EQ(sample_bilinear(image, {0.0, 0.0}), 50.0);
  EXPECT_FALSE(sample_bilinear(image, {2.01, 1.0}));
  EXPECT_FALSE(sample_bilinear(image, {1.0, -0.01}));
  EXPECT_FALSE(sample_bilinear(image, {std::nan(""), 1.0}));
  EXPECT_FALSE(sample_bilinear(ImageView{}, {0.0, 0.0}));
}

TEST(Bilinear, BothSamplersAgreeWellInside) {
  testing::FixedRandom random(8);
  Image image(9, 7);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 9; ++x) image.at(x, y) = static_cast<std::uint8_t>(random.between(0, 255));
  }
  for (const double y : {0.5, 1.25, 3.9, 6.5}) {
    for (const double x : {0.5, 2.0, 7.75, 8.5}) {
      ASSERT_TRUE(well_inside(image, {x, y}));
      // By hand: the four pixels around, weighted by nearness.
      double sum = 0;
      for (int j = 0; j < 7; ++j) {
        for (int i = 0; i < 9; ++i) {
          sum += std::max(0.0, 1 - std::abs(x - i - 0.5)) *
                 std::max(0.0, 1 - std::abs(y - j - 0.5)) * image.at(i, j);
        }
      }
      EXPECT_NEAR(sample_inside(image, {x, y}), sum, 1e-9);
      EXPECT_NEAR(*sample_bilinear(image, {x, y}), sum, 1e-9);
    }
  }
  EXPECT_FALSE(well_inside(image, {0.4, 3}));
  EXPECT_FALSE(well_inside(image, {8.6, 3}));
}

TEST(GrayModel, RecoversAPlane) {
  GrayModel model;
  for (const Point p : {Point{-1, -1}, {1, -1}, {0.3, 0.9}, {-0.2, 0.4}}) {
    model.add(p, 100 + 20 * p.x - 7 * p.y);
  }
  const auto plane = model.fit();
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->at({0.5, -2}), 124, 1e-9);
}

TEST(GrayModel, ResidualsAreThoseOfTheSamples) {
  GrayModel model;
  const std::vector<std::pair<Point, double>> samples = {
      {{-1, -1}, 90}, {{1, -1}, 131}, {{0.3, 0.9}, 96}, {{-0.2, 0.4}, 103}, {{0.5, 0}, 120}};
  for (const auto& [p, gray] : samples) model.add(p, gray);
  const auto plane = model.fit();
  ASSERT_TRUE(plane);
  double expected = 0;
  for (const auto& [p, gray] : samples) {
    expected += (gray - plane->at(p)) * (gray - plane->at(p));
  }
  EXPECT_NEAR(model.squared_residuals(*plane), expected, 1e-8);
}

TEST(GrayModel, TooFewSamplesOrOneLineGiveNone) {
  GrayModel model;
  model.add({0, 0}, 1);
  model.add({1, 1}, 2);
  EXPECT_FALSE(model.fit());
  model.add({2, 2}, 3);
  model.add({3, 3}, 4);
  EXPECT_FALSE(model.fit());
}

Corners rectangle(double left, double top, double right, double bottom) {
  return {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}};
}

Corners reversed(const Corners& c) { return {c[3], c[2], c[1], c[0]}; }

TEST(PolygonOverlap, RectanglesShareTheirCommonRectangle) {
  const Corners a = rectangle(0, 0, 4, 3);
  EXPECT_DOUBLE_EQ(overlap_area(a, rectangle(3, 2, 9, 9)), 1.0);
  EXPECT_DOUBLE_EQ(overlap_area(a, rectangle(1, 1, 2, 2)), 1.0);
  EXPECT_DOUBLE_EQ(overlap_area(rectangle(1, 1, 2, 2), a), 1.0);
  EXPECT_DOUBLE_EQ(overlap_area(a, a), 12.0);
  EXPECT_DOUBLE_EQ(overlap_area(a, rectangle(4, 0, 8, 3)), 0.0);
  EXPECT_DOUBLE_EQ(overlap_area(a, rectangle(5, 5, 8, 8)), 0.0);
}

TEST(PolygonOverlap, DoesNotDependOnTheWinding) {
  const Corners a = rectangle(0, 0, 4, 3);
  const Corners b = rectangle(3, 2, 9, 9);
  EXPECT_DOUBLE_EQ(overlap_area(reversed(a), b), 1.0);
  EXPECT_DOUBLE_EQ(overlap_area(a, reversed(b)), 1.0);
  EXPECT_DOUBLE_EQ(overlap_area(reversed(a), reversed(b)), 1.0);
}

TEST(PolygonOverlap, SquareAndDiamondMakeAnOctagon) {
  const Corners diamond = {{{0, 1.5}, {1.5, 0}, {0, -1.5}, {-1.5, 0}}};
  // The square [-1,1]^2 less four corner triangles with legs 0.5.
  EXPECT_NEAR(overlap_area(rectangle(-1, -1, 1, 1), diamond), 4 - 4 * 0.125, 1e-12);
}

TEST(PolynomialRoots, FindsEachSignChangeInOrder) {
  // (x + 2) (x - 1) (x - 3) (x - 7) = x^4 - 9 x^3 + 9 x^2 + 41 x - 42
  const std::vector<double> roots =
      polynomial_sign_changes(std::vector<double>{-42, 41, 9, -9, 1}, -10, 10);
  ASSERT_EQ(roots.size(), 4u);
  EXPECT_NEAR(roots[0], -2, 1e-12);
  EXPECT_NEAR(roots[1], 1, 1e-12);
  EXPECT_NEAR(roots[2], 3, 1e-12);
  EXPECT_NEAR(roots[3], 7, 1e-12);
}

TEST(PolynomialRoots, ZeroLeadingCoefficientsAndDoubleRootsDoNoHarm) {
  EXPECT_TRUE(polynomial_sign_changes(std::vector<double>{-1, 2, -1}, -5, 5).empty());
  for (const double touch : polynomial_sign_changes(std::vector<double>{1, -2, 1}, -5, 5)) {
    EXPECT_NEAR(touch, 1, 1e-7);
  }
  EXPECT_TRUE(polynomial_sign_changes(std::vector<double>{0, 0, 0}, -5, 5).empty());
  const auto roots = polynomial_sign_changes(std::vector<double>{-1, 2, 0, 0, 0}, -5, 5);
  ASSERT_EQ(roots.size(), 1u);
  EXPECT_NEAR(roots[0], 0.5, 1e-12);
}

}  // namespace
}  // namespace tagmint::detect
