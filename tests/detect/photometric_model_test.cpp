// What the photometric step is made of: edge profile, pattern, prediction, sums, choice of pixels.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "numerics/cholesky.h"
#include "refine/choose_pixels.h"
#include "refine/corner_map.h"
#include "refine/edge_profile.h"
#include "refine/photometric_sums.h"
#include "support/fixed_random.h"
#include "support/instruction_sets.h"
#include "support/paint_tags.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::detect {
namespace {

using testing::FixedRandom;

TEST(EdgeProfile, IsTheNormalIntegralWithinTwoThousandths) {
  for (double t = -4; t <= 4; t += 0.01) {
    EXPECT_NEAR(edge_profile(t).share, 0.5 * std::erfc(-t / std::numbers::sqrt2), 0.002) << t;
  }
}

TEST(EdgeProfile, EndsWithoutAStepForAnyTails) {
  for (const double tails : {-0.3, 0.0, 0.5, 1.0, 1.5}) {
    const EdgeValue end = edge_profile(kEdgeReach - 1e-9, tails);
    EXPECT_NEAR(end.share, 1, 1e-7);
    EXPECT_NEAR(end.slope, 0, 1e-6);
    EXPECT_EQ(edge_profile(0, tails).share, 0.5);
  }
}

TEST(EdgeProfile, SlopesAreThoseOfItsValues) {
  constexpr double kStep = 1e-6;
  for (double t = -2.9; t <= 2.9; t += 0.37) {
    const EdgeValue at = edge_profile(t, 0.4);
    EXPECT_NEAR(
        at.slope,
        (edge_profile(t + kStep, 0.4).share - edge_profile(t - kStep, 0.4).share) / (2 * kStep),
        1e-8);
    EXPECT_NEAR(
        at.by_tails,
        (edge_profile(t, 0.4 + kStep).share - edge_profile(t, 0.4 - kStep).share) / (2 * kStep),
        1e-8);
  }
}

int mixed_difference(const CellSurroundings& around, int code) {
  const auto bits = (around.words[code / kCodesPerWord] >> (4 * (code % kCodesPerWord))) & 0xf;
  return static_cast<int>(bits ^ 8) - 8;
}

TEST(TagPattern, MixedDifferencesAddUpToTheCells) {
  for (const char* name : {"tag36h11", "tagStandard41h12", "tagCustom48h12", "tagCircle21h7"}) {
    const codec::SharedFamily family = codec::find_family(name);
    const codec::TagCells cells = codec::tag_cells(family->layout(), family->codeword(1));
    for (const int edges : {kWideCells, kMiddlingCells, kSmallCells}) {
      TagPattern pattern;
      pattern.begin(*family, 1);
      pattern.finish(edges);
      for (int y = 0; y < pattern.width(); ++y) {
        for (int x = 0; x < pattern.width(); ++x) {
          const int line_x = pattern.first_line(x + 0.25, x);
          const int line_y = pattern.first_line(y + 0.25, y);
          const CellSurroundings& around = pattern.surroundings(line_x, line_y);
          int sum = 0;  // over all edges to the left of and above the cell, and the first cell
          for (int b = 0; b <= y - line_y + 1; ++b) {
            for (int a = 0; a <= x - line_x + 1; ++a) {
              sum += mixed_difference(around, a + b * (edges + 1));
            }
          }
          const codec::Cell cell = cells.at(x, y);
          const int expected = cell == codec::Cell::White ? 2 : cell == codec::Cell::Black ? 0 : 1;
          ASSERT_EQ(sum, expected) << name << ' ' << edges << " cell " << x << ',' << y;
        }
      }
    }
  }
}

TEST(TagPattern, InvertedAndMirroredPrintsAreWhatTheySay) {
  const codec::SharedFamily family = codec::find_family("tag36h11");
  TagPattern plain, inverted, mirrored;
  plain.begin(*family, 3);
  inverted.begin(*family, 3, true, false);
  mirrored.begin(*family, 3, false, true);
  for (int y = 0; y < plain.width(); ++y) {
    for (int x = 0; x < plain.width(); ++x) {
      EXPECT_EQ(inverted.brightness(x, y), 2 - plain.brightness(x, y));
      EXPECT_EQ(mirrored.brightness(x, y), plain.brightness(plain.width() - 1 - x, y));
    }
  }
}

/// A tag seen through a map, with the pixels that would be chosen.
struct Seen {
  Image image;
  TagPattern pattern;
  PixelChoice choice;
  Corners region;
  PhotometricParameters parameters;
};

Seen seen_tag(double side_px, int edges, double tilt_rad) {
  const codec::SharedFamily family = codec::find_family("tag36h11");
  testing::Canvas canvas(120, 110, 130);
  const auto map = testing::tilted_square_at({61.3, 54.8}, side_px, 0.4, tilt_rad, 1.1);
  testing::paint_tag(canvas, *family, 5, map);
  testing::blur(canvas, 0.6);
  FixedRandom random(3);
  Seen seen;
  seen.image = testing::to_gray(canvas, 3, random);
  seen.pattern.begin(*family, 5);
  seen.pattern.finish(edges);
  const Corners corners = testing::corners_of(map);
  seen.choice.frame = {{61.3, 54.8}, side_px / 2};
  seen.choice.to_cells = *map_to_cells(corners, seen.choice.frame, seen.pattern);
  seen.region = *places_in_px(seen.choice.to_cells, seen.choice.frame, outer_corners(seen.pattern));
  seen.parameters.to_cells = seen.choice.to_cells;
  seen.parameters.black = 45;
  seen.parameters.contrast = 160;
  seen.parameters.light_x = 0.1;
  seen.parameters.light_y = -0.05;
  seen.parameters.log_spread = std::log(0.7);
  seen.parameters.tails = 0.3;
  seen.parameters.tone = 0.2;
  return seen;
}

PhotometricPixels chosen(const Seen& seen) {
  PhotometricPixels pixels;
  pixels.reset(most_pixels(seen.image, seen.region, seen.choice.step));
  choose_pixels(seen.image, seen.pattern, seen.choice, seen.region, pixels);
  return pixels;
}

constexpr std::array<int, 3> kAllEdges = {kWideCells, kMiddlingCells, kSmallCells};

TEST(PhotometricModel, JacobianIsTheSlopeOfThePrediction) {
  for (const int edges : kAllEdges) {
    const Seen seen = seen_tag(60, edges, 0.3);
    const PhotometricPixels pixels = chosen(seen);
    ASSERT_GT(pixels.size(), 300U);
    for (std::size_t i = 0; i < pixels.size(); i += 5) {
      PhotometricPixel pixel = pixels.pixel(i);
      pixel.cosine = 0;
      const PhotometricPrediction at = predict(seen.pattern, pixel, seen.parameters);
      for (int a = 0; a < kPhotometricParameters; ++a) {
        const double h = a == kBlackLevel || a == kContrast ? 1e-3 : 1e-6;
        PhotometricVector step{};
        step[a] = h;
        const double up = predict(seen.pattern, pixel, moved(seen.parameters, step)).gray;
        step[a] = -h;
        const double down = predict(seen.pattern, pixel, moved(seen.parameters, step)).gray;
        EXPECT_NEAR(at.slope[a], (up - down) / (2 * h), 1e-3 + 1e-5 * std::abs(at.slope[a]))
            << "parameter " << a << " pixel " << i << " edges " << edges;
      }
    }
  }
}

TEST(PhotometricModel, JacobianIsNearTheSlopeWhereGridLinesAreSlanted) {
  // The series in the cosine is cut off, and its slope is that of its first term.
  const Seen seen = seen_tag(60, kMiddlingCells, 0.3);
  const PhotometricPixels pixels = chosen(seen);
  for (std::size_t i = 0; i < pixels.size(); i += 5) {
    PhotometricPixel pixel = pixels.pixel(i);
    pixel.cosine = 0.3;
    const PhotometricPrediction at = predict(seen.pattern, pixel, seen.parameters);
    for (const int a : {2, 5}) {
      PhotometricVector step{};
      step[a] = 1e-6;
      const double up = predict(seen.pattern, pixel, moved(seen.parameters, step)).gray;
      EXPECT_NEAR(at.slope[a], (up - at.gray) / 1e-6, 30) << a << ' ' << i;  // of some 400
    }
  }
}

void expect_near(const PhotometricSums& sums, const PhotometricSums& reference, double share) {
  EXPECT_NEAR(sums.squared, reference.squared, share * reference.squared);
  EXPECT_NEAR(sums.weight, reference.weight, share * reference.weight);
  for (int a = 0; a < kPhotometricParameters; ++a) {
    // Terms of the gradient cancel; their size is that of derivative times residual.
    const double size = std::sqrt(reference.normal[a][a] * reference.squared);
    EXPECT_NEAR(sums.gradient[a], reference.gradient[a], share * size) << a;
    for (int b = a; b < kPhotometricParameters; ++b) {
      const double scale = std::sqrt(reference.normal[a][a] * reference.normal[b][b]);
      EXPECT_NEAR(sums.normal[a][b], reference.normal[a][b], share * scale) << a << ',' << b;
    }
  }
}

TEST(PhotometricSums, EqualTheReferenceWithEveryInstructionSet) {
  for (const int edges : kAllEdges) {
    const Seen seen = seen_tag(edges == kSmallCells ? 14 : 57, edges, 0.5);
    const PhotometricPixels pixels = chosen(seen);
    ASSERT_GT(pixels.size(), 100U);
    for (const std::size_t step : {std::size_t{1}, std::size_t{3}}) {
      const PhotometricPass pass{.outlier_scale = 25, .block_step = step};
      const PhotometricSums reference =
          scalar::photometric_sums(pixels, seen.pattern, seen.parameters, pass);
      testing::with_every_instruction_set([&] {
        expect_near(photometric_sums(pixels, seen.parameters, edges, pass), reference, 2e-5);
      });
    }
  }
}

TEST(PhotometricSums, HaveTheSameBitsWithEveryInstructionSet) {
  const Seen seen = seen_tag(41, kMiddlingCells, 0.7);
  const PhotometricPixels pixels = chosen(seen);
  const PhotometricPass pass{.outlier_scale = 25};
  const PhotometricPass without{.outlier_scale = 25, .normal = false};
  const PhotometricSums first = photometric_sums(pixels, seen.parameters, kMiddlingCells, pass);
  const PhotometricSums first_without =
      photometric_sums(pixels, seen.parameters, kMiddlingCells, without);
  testing::with_every_instruction_set([&] {
    const PhotometricSums again = photometric_sums(pixels, seen.parameters, kMiddlingCells, pass);
    EXPECT_EQ(again.normal, first.normal);
    EXPECT_EQ(again.gradient, first.gradient);
    EXPECT_EQ(again.squared, first.squared);
    EXPECT_EQ(again.weight, first.weight);
    EXPECT_EQ(photometric_sums(pixels, seen.parameters, kMiddlingCells, without).gradient,
              first_without.gradient);
  });
}

TEST(ChoosePixels, IsTheReferencesChoiceWithEveryInstructionSet) {
  for (const double side : {9.0, 23.0, 71.0}) {
    for (const int edges : kAllEdges) {
      for (const int step : {1, 2, 5}) {
        Seen seen = seen_tag(side, edges, 0.6);
        seen.choice.step = step;
        PhotometricPixels reference;
        reference.reset(most_pixels(seen.image, seen.region, step));
        scalar::choose_pixels(seen.image, seen.pattern, seen.choice, seen.region, nullptr,
                              reference);
        testing::with_every_instruction_set([&] {
          const PhotometricPixels pixels = chosen(seen);
          ASSERT_EQ(pixels.size(), reference.size()) << side << ' ' << edges << ' ' << step;
          for (std::size_t i = 0; i < pixels.size(); ++i) {
            const PhotometricPixel a = pixels.pixel(i);
            const PhotometricPixel b = reference.pixel(i);
            ASSERT_NEAR(a.x, b.x, 1e-5);
            ASSERT_NEAR(a.y, b.y, 1e-5);
            ASSERT_EQ(a.gray, b.gray);
            ASSERT_EQ(a.line_x, b.line_x);
            ASSERT_EQ(a.line_y, b.line_y);
            ASSERT_NEAR(a.across_x, b.across_x, 1e-4 * b.across_x);
            ASSERT_NEAR(a.across_y, b.across_y, 1e-4 * b.across_y);
            ASSERT_NEAR(a.cosine, b.cosine, 1e-4);
            ASSERT_NEAR(a.weight, b.weight, 1e-3);
          }
        });
      }
    }
  }
}

TEST(ChoosePixels, TakesNoneOutsideTheImageOrTheTag) {
  Seen seen = seen_tag(60, kMiddlingCells, 0);
  for (Point& corner : seen.region) corner = corner + Point{-1000, 0};
  EXPECT_EQ(chosen(seen).size(), 0U);
}

TEST(Cholesky, SolvesAndRefuses) {
  FixedRandom random(5);
  constexpr int kSize = 6;
  Cholesky<kSize>::Matrix matrix{};
  std::array<std::array<double, kSize>, 9> rows{};
  for (auto& row : rows) {
    for (double& value : row) value = random.real(-1, 1);
  }
  for (int a = 0; a < kSize; ++a) {
    for (int b = 0; b < kSize; ++b) {
      for (const auto& row : rows) matrix[a][b] += row[a] * row[b];
    }
  }
  Cholesky<kSize> factor;
  ASSERT_TRUE(factor.factor(matrix));
  const Cholesky<kSize>::Vector b = {1, -2, 3, 0.5, 0, 4};
  const Cholesky<kSize>::Vector x = factor.solve(b);
  double squared = 0;
  for (int i = 0; i < kSize; ++i) {
    double sum = 0;
    for (int j = 0; j < kSize; ++j) sum += matrix[i][j] * x[j];
    EXPECT_NEAR(sum, b[i], 1e-10);
    squared += b[i] * x[i];
  }
  const Cholesky<kSize>::Vector lower = factor.solve_lower(b);
  double of_lower = 0;
  for (const double value : lower) of_lower += value * value;
  EXPECT_NEAR(of_lower, squared, 1e-10);  // b A^-1 b, either way
  matrix[3][3] = -1;
  EXPECT_FALSE(factor.factor(matrix));
}

}  // namespace
}  // namespace tagmint::detect
