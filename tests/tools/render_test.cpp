#include "scene/render.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <numbers>

#include "scene/projection.h"
#include "scene/rotation.h"
#include "support/test_families.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::scene {
namespace {

using detect::Corners;
using detect::Point;

/// A tag of classic:10 that turns about `centre`; side of the border square in px.
Corners turned_square(Point centre, double side_px, double angle_deg) {
  const double a = angle_deg * std::numbers::pi / 180;
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point p = side_px / 2 * detect::kTagCorners[i];
    corners[i] = centre + Point{p.x * std::cos(a) - p.y * std::sin(a),
                                p.x * std::sin(a) + p.y * std::cos(a)};
  }
  return corners;
}

Scene plain_scene(int width, int height) {
  Scene scene;
  scene.width = width;
  scene.height = height;
  scene.camera = default_camera(width, height);
  scene.background = PlainBackground{220};
  return scene;
}

SceneTag tag_at(const Corners& corners) {
  return {test::arbitrary_family("classic:10"), 3, corners};
}

SceneTag tag_at(const std::array<double, 3>& position_m, const std::array<double, 3>& angles_deg,
                double edge_m = 0.1) {
  PosedTag posed;
  posed.pose.R = rotation_from_angles(angles_deg);
  posed.pose.t = position_m;
  posed.edge_m = edge_m;
  return {test::arbitrary_family("classic:10"), 3, posed};
}

/// Where the picture changes from white to black along one row (or column), from the sum of its
/// gray levels over a window that begins in white at `begin` and ends in black at `end`: exact for
/// area samples of a straight edge that crosses the row's two borders inside the window.
double edge_position(const detect::Image& image, bool along_row, int line, int begin, int end) {
  double white = 0;
  for (int i = std::min(begin, end); i < std::max(begin, end); ++i) {
    const double level = along_row ? image.at(i, line) : image.at(line, i);
    white += (level - 30) / (220 - 30);
  }
  return begin < end ? begin + white : begin - white;
}

TEST(Render, PutsEdgesRightToAHundredthOfAPixelAtAnyAngle) {
  for (int degrees = -44; degrees <= 44; degrees += 4) {
    Scene scene = plain_scene(400, 400);
    // The border ring is 25 px wide, the white ring outside as well.
    const Corners corners = turned_square({201.37, 198.81}, 200, degrees);
    scene.tags = {tag_at(corners)};
    const detect::Image image = render(scene).image;
    const Point top_left = corners[3];
    const Point bottom_left = corners[0];
    const double y_mid = (top_left.y + bottom_left.y) / 2;
    for (int y = static_cast<int>(y_mid) - 20; y < static_cast<int>(y_mid) + 20; ++y) {
      // The mean of the left edge's x over the row is its x at the row's middle.
      const double t = (y + 0.5 - top_left.y) / (bottom_left.y - top_left.y);
      const double truth = top_left.x + t * (bottom_left.x - top_left.x);
      const int middle = static_cast<int>(truth);
      const double found = edge_position(image, true, y, middle - 12, middle + 12);
      ASSERT_NEAR(found, truth, 0.01) << degrees << " degrees, row " << y;
    }
  }
}

TEST(Render, PutsEdgesOfTiltedTagsOnTheLinesBetweenTheirCorners) {
  for (const double tilt : {-60.0, -30.0, 20.0, 55.0}) {
    Scene scene = plain_scene(640, 480);
    scene.tags = {tag_at({0.01, -0.02, 0.24}, {tilt, 8, 0})};
    const Rendering rendering = render(scene);
    const Corners corners = rendering.truth[0].corners;
    const Point top_left = corners[3];
    const Point top_right = corners[2];
    const double x_mid = (top_left.x + top_right.x) / 2;
    for (int x = static_cast<int>(x_mid) - 30; x < static_cast<int>(x_mid) + 30; ++x) {
      const double t = (x + 0.5 - top_left.x) / (top_right.x - top_left.x);
      const double truth = top_left.y + t * (top_right.y - top_left.y);
      const int middle = static_cast<int>(truth);
      const double found = edge_position(rendering.image, false, x, middle - 6, middle + 6);
      ASSERT_NEAR(found, truth, 0.01) << tilt << " degrees, column " << x;
    }
  }
}

TEST(Render, BendsEdgesAsTheLensDoes) {
  Scene scene = plain_scene(640, 480);
  scene.camera.k1 = -0.25;
  scene.camera.k2 = 0.05;
  scene.camera.p1 = 0.002;
  const SceneTag tag = tag_at({0.0, -0.02, 0.4}, {0, 0, 0}, 0.16);
  scene.tags = {tag};
  const Rendering rendering = render(scene);
  const TagProjection projection(tag.place, scene.camera);
  int columns = 0;
  double bend = 0;
  for (int i = -80; i <= 80; ++i) {
    const Point truth = projection.project({i / 100.0, -1});
    const Corners c = rendering.truth[0].corners;
    bend = std::max(bend, std::abs(truth.y - (c[3].y + (truth.x - c[3].x) * (c[2].y - c[3].y) /
                                                           (c[2].x - c[3].x))));
    // A column's mean is compared with the curve at its middle.
    const int x = static_cast<int>(truth.x);
    const Point next = projection.project({i / 100.0 + 1e-4, -1});
    const double slope = (next.y - truth.y) / (next.x - truth.x);
    const double at_middle = truth.y + slope * (x + 0.5 - truth.x);
    const int middle = static_cast<int>(truth.y);
    const double found = edge_position(rendering.image, false, x, middle - 8, middle + 8);
    ASSERT_NEAR(found, at_middle, 0.01) << "column " << x;
    ++columns;
  }
  EXPECT_EQ(columns, 161);
  EXPECT_GT(bend, 1.5);  // px: the lens does bend this edge
}

TEST(Render, CornersAreTheProjectionOfThePose) {
  Scene scene = plain_scene(640, 480);
  scene.camera = {.fx = 610, .fy = 590, .cx = 322, .cy = 236};
  scene.tags = {tag_at({0.03, -0.04, 0.5}, {25, -40, 70})};
  const auto& posed = std::get<PosedTag>(scene.tags[0].place);
  const TagTruth truth = render(scene).truth[0];
  const auto& R = posed.pose.R;
  const auto& t = posed.pose.t;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point p = 0.05 * detect::kTagCorners[i];
    const double X = R[0] * p.x + R[1] * p.y + t[0];
    const double Y = R[3] * p.x + R[4] * p.y + t[1];
    const double Z = R[6] * p.x + R[7] * p.y + t[2];
    EXPECT_NEAR(truth.corners[i].x, 610 * X / Z + 322, 1e-9);
    EXPECT_NEAR(truth.corners[i].y, 590 * Y / Z + 236, 1e-9);
    ASSERT_TRUE(truth.homography);
    const Point mapped = truth.homography->project(detect::kTagCorners[i]);
    EXPECT_NEAR(mapped.x, truth.corners[i].x, 1e-9);
    EXPECT_NEAR(mapped.y, truth.corners[i].y, 1e-9);
  }
  EXPECT_DOUBLE_EQ((*truth.homography)(2, 2), 1);
}

TEST(Render, FrontalUprightTagHasItsFirstCornerAtTheBottomLeft) {
  Scene scene = plain_scene(640, 480);
  scene.tags = {tag_at({0, 0, 0.5}, {0, 0, 0})};
  const Corners corners = render(scene).truth[0].corners;  // 640 px * 0.1 m / 0.5 m = 128 px
  EXPECT_NEAR(corners[0].x, 320 - 64, 1e-9);
  EXPECT_NEAR(corners[0].y, 240 + 64, 1e-9);
  EXPECT_NEAR(corners[2].x, 320 + 64, 1e-9);
  EXPECT_NEAR(corners[2].y, 240 - 64, 1e-9);
}

TEST(Render, AnglesTurnAsTheyAreDocumented) {
  const auto depth_and_place = [](const std::array<double, 3>& angles, Point p) {
    const auto R = rotation_from_angles(angles);
    return std::array<double, 3>{R[0] * p.x + R[1] * p.y, R[3] * p.x + R[4] * p.y,
                                 R[6] * p.x + R[7] * p.y};
  };
  EXPECT_GT(depth_and_place({30, 0, 0}, {0, 1})[2], 0);  // lower edge away
  EXPECT_LT(depth_and_place({0, 30, 0}, {1, 0})[2], 0);  // right edge nearer
  EXPECT_GT(depth_and_place({0, 0, 30}, {1, 0})[1], 0);  // clockwise as seen
}

TEST(Render, DependsOnTheSeedAndNotOnThreads) {
  Scene scene = plain_scene(320, 240);
  scene.background = TextureBackground{};
  scene.tags = {tag_at({0, 0, 0.5}, {20, 30, 40})};
  scene.effects.noise_sigma = 5;
  scene.effects.blur_sigma_px = 1;
  scene.effects.shading.strength = 0.3;
  const detect::Image one = render(scene, 1).image;
  EXPECT_EQ(one, render(scene, 4).image);
  EXPECT_EQ(one, render(scene, 0).image);
  scene.seed = 2;
  EXPECT_NE(one, render(scene, 1).image);
}

TEST(Render, OfAllEffectsDoesNotDependOnThreads) {
  Scene scene = plain_scene(320, 240);
  scene.background = ClutterBackground{};
  scene.tags = {tag_at({0, 0, 0.5}, {20, 30, 40}), tag_at({0.1, 0, 0.6}, {-20, 10, 80})};
  scene.marks = {{.path = {{100, 90}, {200, 140}}, .width_px = 5}};
  scene.effects.shadows = {{.polygon = {{0, 0}, {180, 0}, {120, 240}, {0, 240}}, .light = 0.5}};
  scene.effects.glare = {{.centre = {160, 100}, .radius_px = 20, .strength = 90}};
  scene.effects.vignetting = 0.4;
  scene.effects.motion_blur = {.length_px = 5, .angle_deg = 20};
  scene.effects.defocus_px = 1.2;
  scene.effects.blur_sigma_px = 0.6;
  scene.effects.electrons_per_level = 20;
  scene.effects.gamma = 2.2;
  scene.effects.noise_sigma = 2;
  scene.effects.jpeg_quality = 85;
  // More threads than cores, too.
  const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  for (const double blur_px : {0.6, 4.0}) {
    scene.effects.blur_sigma_px = blur_px;
    const Rendering one = render(scene, 1);
    for (const int threads : {2, 3, 5, 8, 0}) {
      for (int again = 0; again < 3; ++again) {
        const Rendering other = render(scene, threads);
        ASSERT_EQ(one.image, other.image) << threads;
        ASSERT_EQ(one.jpeg, other.jpeg) << threads;
        for (std::size_t i = 0; i < 2; ++i) {
          EXPECT_EQ(one.truth[i].corners, other.truth[i].corners);
          EXPECT_EQ(one.truth[i].visible_px, other.truth[i].visible_px);
        }
      }
    }
  }
}

TEST(Render, EffectsMoveNoCorners) {
  Scene scene = plain_scene(320, 240);
  scene.tags = {tag_at({0, 0, 0.5}, {20, 30, 40})};
  const Rendering plain = render(scene);
  scene.effects.motion_blur = {.length_px = 5, .angle_deg = 20};
  scene.effects.defocus_px = 1.2;
  scene.effects.gamma = 2.2;
  const Rendering other = render(scene);
  EXPECT_NE(plain.image, other.image);
  EXPECT_EQ(plain.truth[0].corners, other.truth[0].corners);
}

TEST(Render, LaysMarksOverTags) {
  Scene scene = plain_scene(200, 200);
  scene.tags = {tag_at(turned_square({100, 100}, 80, 0))};  // border from 60 to 140
  scene.marks = {{.path = {{65, 100}}, .width_px = 6, .gray = 120}};
  const detect::Image image = render(scene).image;
  EXPECT_EQ(image.at(65, 100), 120);
  EXPECT_EQ(image.at(65, 110), 30);
}

TEST(Render, DrawsEveryCellOfTheTag) {
  const codec::SharedFamily family = test::arbitrary_family("circle:9");
  Scene scene = plain_scene(200, 200);
  scene.background = PlainBackground{100};
  scene.quiet_zone_cells = 0;
  const int border = family->layout().width_at_border();
  scene.tags = {{family, 2, turned_square({100, 100}, 10.0 * border, 0)}};
  const detect::Image image = render(scene).image;
  const codec::TagCells cells = tag_cells(family->layout(), family->codeword(2));
  for (int y = 0; y < cells.width(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      const int expected = cells.at(x, y) == codec::Cell::Black   ? 30
                           : cells.at(x, y) == codec::Cell::White ? 220
                                                                  : 100;
      const int first = 100 - 5 * cells.width();
      for (const int inset : {0, 5, 9}) {
        EXPECT_EQ(image.at(first + 10 * x + inset, first + 10 * y + inset), expected);
      }
    }
  }
}

TEST(Render, QuietZoneIsAsManyCellsWideAsAskedFor) {
  for (const int cells : {0, 1, 3}) {
    Scene scene = plain_scene(400, 400);
    scene.background = PlainBackground{60};
    scene.quiet_zone_cells = cells;
    scene.tags = {tag_at(turned_square({200, 200}, 80, 0))};  // cells of 10 px, 100 px in all
    const detect::Image image = render(scene).image;
    const int first = 150 - 10 * cells;
    EXPECT_EQ(image.at(first, 200), 220);
    EXPECT_EQ(image.at(first - 1, 200), 60);
    EXPECT_EQ(image.at(first, first), 220);
    EXPECT_EQ(image.at(first - 1, first - 1), 60);
  }
}

TEST(Render, LaterTagsHideEarlierOnes) {
  Scene scene = plain_scene(400, 300);
  scene.quiet_zone_cells = 0;
  scene.tags = {tag_at(turned_square({150, 150}, 80, 0)),   // 100 px wide with its white ring
                tag_at(turned_square({200, 150}, 80, 0))};  // covers its right half
  const Rendering rendering = render(scene);
  EXPECT_NEAR(rendering.truth[0].visible, 0.5, 1e-6);
  EXPECT_NEAR(rendering.truth[1].visible, 1, 1e-6);
  EXPECT_EQ(rendering.image.at(155, 150), 220);  // the upper tag's white ring
  EXPECT_EQ(rendering.image.at(165, 150), 30);   // its border
}

TEST(Render, VisibleShareCountsWhatTheImageCutsOff) {
  Scene scene = plain_scene(400, 300);
  scene.tags = {tag_at(turned_square({0, 150}, 80, 0)), tag_at(turned_square({400, 300}, 80, 0)),
                tag_at(turned_square({-500, 0}, 80, 0)), tag_at(turned_square({200, 150}, 80, 30))};
  const Rendering rendering = render(scene);
  EXPECT_NEAR(rendering.truth[0].visible, 0.5, 1e-6);
  EXPECT_NEAR(rendering.truth[1].visible, 0.25, 1e-6);
  EXPECT_EQ(rendering.truth[2].visible, 0);
  EXPECT_NEAR(rendering.truth[3].visible, 1, 1e-6);
  // 100 px wide with its white ring.
  EXPECT_NEAR(rendering.truth[0].visible_px, 5000, 0.01);
  EXPECT_NEAR(rendering.truth[3].visible_px, 10000, 0.01);
  // On a grid finer than the pixels it is the same area.
  scene.effects.blur_sigma_px = 0.5;
  const Rendering blurred = render(scene);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(blurred.truth[i].visible_px, rendering.truth[i].visible_px, 0.01);
  }
}

TEST(Render, DrawsATagThatReachesBehindTheCamera) {
  Scene scene = plain_scene(320, 240);
  // A large floor: its far part is seen, its near part is behind the viewer.
  scene.tags = {tag_at({0, 0.3, 0.5}, {-80, 0, 0}, 4)};
  const Rendering rendering = render(scene);
  EXPECT_GT(rendering.truth[0].visible, 0);
  EXPECT_LT(rendering.truth[0].visible, 0.5);
  // Rays through the pixels' corners: where all four meet the same cell, its colour is seen.
  const codec::Family& family = *scene.tags[0].family;
  const codec::TagCells cells = tag_cells(family.layout(), family.codeword(3));
  const auto to_tag = rendering.truth[0].homography->inverse();
  ASSERT_TRUE(to_tag);
  const auto level_at = [&](double x, double y) {
    // Tag points on the far side of the horizon have the other sign of depth.
    const Point p = to_tag->project({x, y});
    const bool in_front = TagProjection(scene.tags[0].place, scene.camera).depth(p) > 0;
    const int column = static_cast<int>(std::floor(4 * p.x + 5));
    const int row = static_cast<int>(std::floor(4 * p.y + 5));
    const bool on_tag = in_front && column >= 0 && row >= 0 && column < 10 && row < 10;
    return on_tag && cells.at(column, row) == codec::Cell::Black ? 30 : 220;
  };
  int black = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      const int level = level_at(x, y);
      if (level != level_at(x + 1, y) || level != level_at(x, y + 1) ||
          level != level_at(x + 1, y + 1) || rendering.image.at(x, y) == level) {
        black += level == 30;
        continue;
      }
      // A cell's corner or a thin sliver may lie inside one pixel.
      ASSERT_NEAR(rendering.image.at(x, y), level, 95) << x << ' ' << y;
    }
  }
  EXPECT_GT(black, 5000);
}

TEST(Render, RefusesImpossibleScenes) {
  const auto refused = [](auto change, const std::string& part) {
    Scene scene = plain_scene(320, 240);
    scene.tags = {tag_at({0, 0, 0.5}, {0, 0, 0})};
    change(scene);
    try {
      render(scene);
      FAIL() << "drawn, although: " << part;
    } catch (const std::invalid_argument& fault) {
      EXPECT_NE(std::string(fault.what()).find(part), std::string::npos) << fault.what();
    }
  };
  refused([](Scene& s) { s.width = 0; }, "width is 0");
  refused([](Scene& s) { s.height = 1 << 20; }, "height is");
  refused([](Scene& s) { s.quiet_zone_cells = -1; }, "quiet_zone_cells");
  refused([](Scene& s) { s.effects.noise_sigma = -1; }, "noise is -1");
  refused([](Scene& s) { s.effects.blur_sigma_px = std::nan(""); }, "blur_px");
  refused([](Scene& s) { s.effects.black = 230; }, "black must be the darker");
  refused([](Scene& s) { s.effects.shading.strength = 1; }, "shading.strength");
  refused([](Scene& s) { s.background = PhotoBackground{}; }, "no pixels");
  refused([](Scene& s) { s.background = ClutterBackground{.shapes = -1}; }, "clutter.shapes is -1");
  refused([](Scene& s) { s.marks = {{.path = {{std::nan(""), 0}}}}; }, "marks[0].path holds");
  refused([](Scene& s) { s.marks = {{.path = {{1, 1}}, .width_px = 0}}; }, "marks[0].width_px");
  refused([](Scene& s) { s.effects.shadows = {{.polygon = {{0, 0}, {1, 1}}}}; }, "three corners");
  refused([](Scene& s) { s.effects.glare = {{.radius_px = 0}}; }, "glare[0].radius_px is 0");
  refused([](Scene& s) { s.effects.vignetting = 1; }, "vignetting is 1");
  refused([](Scene& s) { s.effects.gamma = 0; }, "gamma is 0");
  refused([](Scene& s) { s.tags[0].id = 8; }, "tags[0]: id 8 is not in");
  refused([](Scene& s) { s.tags[0].family = nullptr; }, "no family");
  refused([](Scene& s) { s.tags[0] = tag_at({0, 0, -1}, {0, 0, 0}); }, "behind the camera");
  refused([](Scene& s) { s.tags[0] = tag_at({0, 0, 1}, {0, 120, 0}); }, "faces away");
  refused([](Scene& s) { std::get<PosedTag>(s.tags[0].place).edge_m = 0; }, "edge_m is 0");
  refused([](Scene& s) { std::get<PosedTag>(s.tags[0].place).pose.R[0] = 2; }, "no rotation");
  refused(
      [](Scene& s) { std::get<PosedTag>(s.tags[0].place).pose.R = {1, 0, 0, 0, 1, 0, 0, 0, -1}; },
      "reflection");
  refused(
      [](Scene& s) {
        Corners corners = turned_square({100, 100}, 50, 0);
        std::swap(corners[1], corners[3]);
        s.tags[0] = tag_at(corners);
      },
      "counter-clockwise");
  refused(
      [](Scene& s) {
        s.camera.k1 = -1;
        s.tags[0] = tag_at({0.3, 0, 0.5}, {0, 0, 0});
      },
      "folds back");
}

}  // namespace
}  // namespace tagmint::scene
