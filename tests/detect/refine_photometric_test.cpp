// The photometric step on painted tags whose corners are known.
#include "refine/refine_photometric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/fixed_random.h"
#include "support/instruction_sets.h"
#include "support/paint_tags.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::detect {
namespace {

using testing::FixedRandom;

/// A painted tag and where it is.
struct Painted {
  testing::Canvas canvas;
  codec::SharedFamily family;
  Corners truth;
};

constexpr codec::TagId kId = 4;

Painted paint(const std::string& name, double side_px, double tilt_rad = 0.4,
              const testing::Ink& ink = {}) {
  Painted painted{testing::Canvas(160, 150, 130), codec::find_family(name), {}};
  const auto map = testing::tilted_square_at({81.3, 74.6}, side_px, 0.5, tilt_rad, 0.8);
  testing::paint_tag(painted.canvas, *painted.family, kId, map, ink);
  painted.truth = testing::corners_of(map);
  return painted;
}

Image photographed(Painted& painted, double noise) {
  testing::blur(painted.canvas, 0.8);
  FixedRandom random(11);
  return testing::to_gray(painted.canvas, noise, random);
}

/// Corners as a detector finds them: off by up to `off_px`.
Corners shaken(const Corners& truth, double off_px) {
  FixedRandom random(2);
  Corners corners = truth;
  for (Point& p : corners)
    p = p + Point{random.real(-off_px, off_px), random.real(-off_px, off_px)};
  return corners;
}

double largest_error(const Corners& corners, const Corners& truth) {
  double largest = 0;
  for (int i = 0; i < 4; ++i) largest = std::max(largest, length(corners[i] - truth[i]));
  return largest;
}

std::optional<PhotometricFit> refined(const Image& image, const Painted& painted,
                                      const Corners& corners) {
  PhotometricScratch scratch;
  return refine_photometric(image, *painted.family, kId, corners, {}, scratch);
}

class RefinePhotometric : public ::testing::TestWithParam<std::string> {};

TEST_P(RefinePhotometric, FindsTheCornersOfEveryLayout) {
  for (const double side : {24.0, 50.0, 90.0}) {
    Painted painted = paint(GetParam(), side);
    const Image image = photographed(painted, 1);
    const auto fit = refined(image, painted, shaken(painted.truth, 0.25));
    ASSERT_TRUE(fit) << side;
    // Noise of one level in 170 leaves some thousandths, edges painted by 64 points a pixel and
    // blurred between pixels some hundredths.
    EXPECT_LT(largest_error(fit->corners, painted.truth), 0.05) << side;
    EXPECT_NEAR(fit->parameters.black, 40, 8);
    EXPECT_NEAR(fit->parameters.contrast, 170, 12);
  }
}

INSTANTIATE_TEST_SUITE_P(Layouts, RefinePhotometric,
                         ::testing::Values("tag36h11", "tag16h5", "tagStandard41h12",
                                           "tagCircle49h12", "tagCircle21h7", "tagCustom48h12"),
                         [](const auto& each) { return each.param; });

TEST(RefinePhotometricStep, HasTheSameBitsWithEveryInstructionSet) {
  Painted painted = paint("tag36h11", 47);
  const Image image = photographed(painted, 4);
  const auto first = refined(image, painted, shaken(painted.truth, 0.2));
  ASSERT_TRUE(first);
  testing::with_every_instruction_set([&] {
    const auto again = refined(image, painted, shaken(painted.truth, 0.2));
    ASSERT_TRUE(again);
    EXPECT_EQ(again->corners, first->corners);
    EXPECT_EQ(again->covariance, first->covariance);
  });
}

TEST(RefinePhotometricStep, SpecksAndCoveredCellsPullLittle) {
  Painted painted = paint("tag36h11", 60);
  // Dark specks on the border's edge and a bright patch over two cells.
  for (const Point speck : {0.5 * (painted.truth[0] + painted.truth[1]),
                            0.3 * painted.truth[2] + 0.7 * painted.truth[3]}) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        painted.canvas.at(static_cast<int>(speck.x) + dx, static_cast<int>(speck.y) + dy) = 20;
      }
    }
  }
  for (int y = 70; y < 77; ++y) {
    for (int x = 78; x < 91; ++x) painted.canvas.at(x, y) = 215;
  }
  const Image image = photographed(painted, 2);
  const auto fit = refined(image, painted, shaken(painted.truth, 0.2));
  ASSERT_TRUE(fit);
  EXPECT_LT(largest_error(fit->corners, painted.truth), 0.06);
}

TEST(RefinePhotometricStep, InkOutsideTheQuietZoneDoesNotPull) {
  testing::Ink bare;
  bare.quiet_cells = 0;  // the layout's own white ring alone
  for (const float outside : {5.0F, 250.0F}) {
    Painted painted = paint("tag36h11", 36, 0.4, bare);
    for (float& level : painted.canvas.gray) {
      if (level == 130) level = outside;
    }
    const Image image = photographed(painted, 1);
    const auto fit = refined(image, painted, shaken(painted.truth, 0.2));
    ASSERT_TRUE(fit) << outside;
    EXPECT_LT(largest_error(fit->corners, painted.truth), 0.03) << outside;
  }
}

TEST(RefinePhotometricStep, AnImageEdgeThroughTheQuietZoneDoesNoHarm) {
  Painted painted = paint("tag36h11", 60, 0);
  double left = 1e9;
  for (const Point p : painted.truth) left = std::min(left, p.x);
  const int cut = static_cast<int>(left) + 1;  // a part of a cell of the border goes too
  const Image image = photographed(painted, 1);
  const ImageView whole = image.view();
  const ImageView part{whole.data + cut, whole.width - cut, whole.height, whole.stride};
  Corners truth = painted.truth;
  for (Point& p : truth) p = p - Point{static_cast<double>(cut), 0};
  PhotometricScratch scratch;
  const auto fit = refine_photometric(part, *painted.family, kId, shaken(truth, 0.2), {}, scratch);
  ASSERT_TRUE(fit);
  EXPECT_LT(largest_error(fit->corners, truth), 0.03);
}

TEST(RefinePhotometricStep, RefusesWhereTheTagIsNot) {
  Painted painted = paint("tag36h11", 60);
  FixedRandom random(4);
  const Image nothing = testing::to_gray(testing::Canvas(160, 150, 130), 10, random);
  EXPECT_FALSE(refined(nothing, painted, painted.truth));
  // Half a cell and more away the drawing and the picture are in each other's way.
  const Image image = photographed(painted, 1);
  Corners far = painted.truth;
  for (Point& p : far) p = p + Point{9, 7};
  const auto fit = refined(image, painted, far);
  EXPECT_TRUE(!fit || largest_error(fit->corners, far) <= 1);
}

TEST(RefinePhotometricStep, LeavesPicturesThatNoLensMadeToTheEdges) {
  Painted drawn = paint("tag36h11", 90, 0.0);
  FixedRandom random(11);
  const Image crisp = testing::to_gray(drawn.canvas, 0, random);
  EXPECT_FALSE(refined(crisp, drawn, shaken(drawn.truth, 0.1)));
  // The same tag through a lens.
  const Image blurred = photographed(drawn, 0);
  EXPECT_TRUE(refined(blurred, drawn, shaken(drawn.truth, 0.1)));
}

TEST(RefinePhotometricStep, FindsMirroredAndInvertedTagsToo) {
  const codec::SharedFamily family = codec::find_family("tag36h11");
  testing::Canvas canvas(160, 150, 130);
  auto map = testing::square_at({81.3, 74.6}, 50, 0.4);
  const auto& h = map.row_major();
  const Homography mirror({-h[0], h[1], h[2], -h[3], h[4], h[5], -h[6], h[7], h[8]});
  testing::Ink inverse;
  std::swap(inverse.black, inverse.white);
  testing::paint_tag(canvas, *family, kId, mirror, inverse);
  testing::blur(canvas, 0.8);
  FixedRandom random(1);
  const Image image = testing::to_gray(canvas, 1, random);
  Detection detection;
  detection.family = family;
  detection.id = kId;
  detection.inverted = detection.mirrored = true;
  const Corners truth = testing::corners_of(mirror);
  detection.corners = shaken(truth, 0.2);
  PhotometricScratch scratch;
  ASSERT_TRUE(refine_detection(image, detection, {}, scratch));
  EXPECT_LT(largest_error(detection.corners, truth), 0.03);
  ASSERT_TRUE(detection.corner_covariance);
  EXPECT_GT((*detection.corner_covariance)[0], 0);
}

TEST(RefinePhotometricStep, FollowsCurvedSidesThroughALensThatIsKnown) {
  const codec::SharedFamily family = codec::find_family("tag36h11");
  const Camera lens{.fx = 150, .fy = 150, .cx = 80, .cy = 75, .k1 = -0.25, .k2 = 0.04};
  const auto map = testing::square_at({95, 84}, 70, 0.3);  // in ideal pixels
  // Painted straight at three times the size, then each pixel looked up through the lens.
  constexpr int kFine = 4;
  testing::Canvas straight(200 * kFine, 190 * kFine, 130);
  const Homography fine({map(0, 0) * kFine, map(0, 1) * kFine, (map(0, 2) + 15) * kFine,
                         map(1, 0) * kFine, map(1, 1) * kFine, (map(1, 2) + 15) * kFine, map(2, 0),
                         map(2, 1), map(2, 2)});
  testing::paint_tag(straight, *family, kId, fine);
  testing::Canvas canvas(160, 150, 0);
  for (int y = 0; y < canvas.height; ++y) {
    for (int x = 0; x < canvas.width; ++x) {
      double sum = 0;
      for (int j = 0; j < 6; ++j) {
        for (int i = 0; i < 6; ++i) {
          const Point n = lens.to_normalised({x + (i + 0.5) / 6, y + (j + 0.5) / 6});
          const Point ideal{lens.fx * n.x + lens.cx, lens.fy * n.y + lens.cy};
          sum += straight.at(
              std::clamp(static_cast<int>((ideal.x + 15) * kFine), 0, straight.width - 1),
              std::clamp(static_cast<int>((ideal.y + 15) * kFine), 0, straight.height - 1));
        }
      }
      canvas.at(x, y) = static_cast<float>(sum / 36);
    }
  }
  testing::blur(canvas, 0.8);
  FixedRandom random(1);
  const Image image = testing::to_gray(canvas, 1, random);
  Corners truth;
  for (int i = 0; i < 4; ++i) {
    const Point ideal = map.project(kTagCorners[i]);
    truth[i] = lens.to_pixel({(ideal.x - lens.cx) / lens.fx, (ideal.y - lens.cy) / lens.fy});
  }
  PhotometricScratch scratch;
  const auto known =
      refine_photometric(image, *family, kId, shaken(truth, 0.2), {.lens = lens}, scratch);
  ASSERT_TRUE(known);
  EXPECT_LT(largest_error(known->corners, truth), 0.05);
  // Without the lens the sides' sagitta stays; the step takes no corner far.
  const auto unknown = refine_photometric(image, *family, kId, truth, {}, scratch);
  EXPECT_LT(unknown ? largest_error(unknown->corners, truth) : 0, 1.0);
}

}  // namespace
}  // namespace tagmint::detect
