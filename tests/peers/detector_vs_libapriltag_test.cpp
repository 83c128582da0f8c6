// Our detector beside libapriltag on the same pictures of tag36h11.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <vector>

// libapriltag's own headers mark only some of its functions as C.
extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/apriltag_pose.h>
#include <apriltag/tag36h11.h>
}

#include "support/fixed_random.h"
#include "support/paint_tags.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/detect/detector.h"
#include "tagmint/detect/pose.h"

namespace tagmint::detect {
namespace {

using testing::Canvas;
using testing::FixedRandom;

/// Debian's library exports none of its matrix functions; a matrix is one block from malloc.
double element(const matd_t* m, unsigned row, unsigned column) { return MATD_EL(m, row, column); }

/// What libapriltag found, in our types.
struct PeerDetection {
  int id = 0;
  Point center;
  Corners corners;
  Homography homography;
  Pose pose;
};

constexpr double kEdge = 0.12;
const Camera kCamera{.fx = 900, .fy = 900, .cx = 640, .cy = 480};

class Peer {
 public:
  Peer() : family_(tag36h11_create()), detector_(apriltag_detector_create()) {
    apriltag_detector_add_family_bits(detector_, family_, 2);
    detector_->nthreads = 1;
    detector_->quad_decimate = 1;
  }
  ~Peer() {
    apriltag_detector_destroy(detector_);
    tag36h11_destroy(family_);
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  std::vector<PeerDetection> detect(Image& image, bool with_pose) {
    image_u8_t view = {image.width(), image.height(), image.width(), image.row(0)};
    zarray_t* found = apriltag_detector_detect(detector_, &view);
    std::vector<PeerDetection> detections;
    for (int i = 0; i < zarray_size(found); ++i) {
      apriltag_detection_t* d = nullptr;
      zarray_get(found, i, &d);
      detections.push_back(converted(*d, with_pose));
    }
    apriltag_detections_destroy(found);
    return detections;
  }

 private:
  static PeerDetection converted(apriltag_detection_t& d, bool with_pose) {
    PeerDetection mine;
    mine.id = d.id;
    mine.center = {d.c[0], d.c[1]};
    for (int i = 0; i < 4; ++i) mine.corners[i] = {d.p[i][0], d.p[i][1]};
    std::array<double, 9> h;
    for (int i = 0; i < 9; ++i) h[i] = element(d.H, i / 3, i % 3) / element(d.H, 2, 2);
    mine.homography = Homography(h);
    if (with_pose) {
      apriltag_detection_info_t info = {&d, kEdge, kCamera.fx, kCamera.fy, kCamera.cx, kCamera.cy};
      apriltag_pose_t pose;
      mine.pose.error = estimate_tag_pose(&info, &pose);
      for (int i = 0; i < 9; ++i) mine.pose.R[i] = element(pose.R, i / 3, i % 3);
      for (int i = 0; i < 3; ++i) mine.pose.t[i] = element(pose.t, i, 0);
      std::free(pose.R);
      std::free(pose.t);
    }
    return mine;
  }

  apriltag_family_t* family_;
  apriltag_detector_t* detector_;
};

struct Placed {
  codec::TagId id = 0;
  Homography homography;
  Pose pose;
};

struct Scene {
  Image image;
  std::vector<Placed> tags;
};

/// How kCamera sees the border square of a tag in this pose.
Homography seen(const Pose& pose) {
  std::array<double, 9> h;
  for (int column = 0; column < 3; ++column) {
    const auto entry = [&](int row) {
      return column < 2 ? kEdge / 2 * pose.R[row * 3 + column] : pose.t[row];
    };
    h[column] = kCamera.fx * entry(0) + kCamera.cx * entry(2);
    h[3 + column] = kCamera.fy * entry(1) + kCamera.cy * entry(2);
    h[6 + column] = entry(2);
  }
  return Homography(h);
}

/// A tag seen in the given direction, leaning back about an axis in its plane after a turn.
Pose pose_of(Point pixel, double distance_m, double turn, double lean, double axis) {
  const Eigen::Vector3d lean_axis(std::cos(axis), std::sin(axis), 0);
  const Eigen::Matrix3d R =
      (Eigen::AngleAxisd(lean, lean_axis) * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  Pose pose;
  for (int i = 0; i < 9; ++i) pose.R[i] = R(i / 3, i % 3);
  const Point direction = kCamera.to_normalised(pixel);
  pose.t = {direction.x * distance_m, direction.y * distance_m, distance_m};
  return pose;
}

/// Tags in a grid, at random distances, turned and leaning at random.
Scene scene_of(int columns, int rows, int pitch, double least_side, double largest_side,
               double noise) {
  const codec::SharedFamily family = codec::find_family("tag36h11");
  FixedRandom random(31);
  Canvas canvas(columns * pitch, rows * pitch, 130);
  Scene scene;
  for (int i = 0; i < columns * rows; ++i) {
    const double side = random.real(least_side, largest_side);
    const Pose pose = pose_of({(i % columns + 0.5) * pitch, (i / columns + 0.5) * pitch},
                              kCamera.fx * kEdge / side, random.real(0, 2 * std::numbers::pi),
                              random.real(0.1, 0.9), random.real(0, 2 * std::numbers::pi));
    const auto id = static_cast<codec::TagId>(i % family->size());
    testing::paint_tag(canvas, *family, id, seen(pose));
    scene.tags.push_back({id, seen(pose), pose});
  }
  testing::blur(canvas, 0.5);
  scene.image = testing::to_gray(canvas, noise, random);
  return scene;
}

std::shared_ptr<const codec::Decoder> decoder() {
  return std::make_shared<const codec::Decoder>(codec::find_family("tag36h11"));
}

double angle_deg(const Pose& a, const Pose& b) {
  double trace = 0;
  for (int i = 0; i < 9; ++i) trace += a.R[i] * b.R[i];
  return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
}

TEST(DetectorVsLibapriltag, SameIdsCornersHomographiesAndPoses) {
  Scene scene = scene_of(5, 4, 190, 50, 90, 2);
  const auto theirs = Peer().detect(scene.image, true);
  const auto ours = Detector({decoder()}).detect(scene.image);
  ASSERT_EQ(theirs.size(), scene.tags.size());
  ASSERT_EQ(ours.size(), scene.tags.size());
  for (const PeerDetection& peer : theirs) {
    const auto own = std::find_if(ours.begin(), ours.end(), [&](const Detection& d) {
      return static_cast<int>(d.id) == peer.id && length(d.center - peer.center) < 2;
    });
    ASSERT_NE(own, ours.end()) << peer.id;
    EXPECT_LT(length(own->center - peer.center), 0.3);
    for (int i = 0; i < 4; ++i) {
      EXPECT_LT(length(own->corners[i] - peer.corners[i]), 0.3) << peer.id << " corner " << i;
    }
    for (const Point p : {Point{0.5, 0.2}, Point{-0.8, 0.4}, Point{-1, -1}, Point{0, 1}}) {
      EXPECT_LT(length(own->homography.project(p) - peer.homography.project(p)), 0.3) << peer.id;
    }
    // From corners up to 0.3 px apart on sides of 50 px and more. A tag seen at a slant has one
    // clear pose; near the front either of the two may come first.
    const auto pose = estimate_pose(own->corners, kCamera, kEdge);
    ASSERT_TRUE(pose) << peer.id;
    const double best = angle_deg(pose->best, peer.pose);
    const double other = pose->alternative ? angle_deg(*pose->alternative, peer.pose) : best;
    EXPECT_LT(std::min(best, other), 6.0) << peer.id;
    EXPECT_NEAR(pose->best.t[2], peer.pose.t[2], 0.02 * peer.pose.t[2]);
  }
}

TEST(DetectorVsLibapriltag, SamePoseFromTheSameCornersOrANearerOne) {
  // libapriltag stops after 50 iterations, near the front before it has converged. Its error is the
  // sum over the corners, ours the mean; a smaller error is a better minimum of the same function.
  Scene scene = scene_of(5, 4, 190, 50, 90, 2);
  int same = 0;
  for (const PeerDetection& peer : Peer().detect(scene.image, true)) {
    const auto pose = estimate_pose(peer.corners, kCamera, kEdge);
    ASSERT_TRUE(pose);
    const double sum = 4 * pose->best.error;
    EXPECT_LE(sum, peer.pose.error * (1 + 1e-6)) << peer.id;
    EXPECT_LT(angle_deg(pose->best, peer.pose), 2.5) << peer.id;
    if (sum < 0.999 * peer.pose.error) continue;
    ++same;
    EXPECT_LT(angle_deg(pose->best, peer.pose), 0.03) << peer.id;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(pose->best.t[i], peer.pose.t[i], 1e-4) << peer.id;
  }
  EXPECT_GE(same, 8);
}

/// How well the tags of a scene were found.
struct Score {
  int found = 0;
  double median_px = 0;
};

template <typename Found>
Score score(const Scene& scene, const std::vector<Found>& detections) {
  std::vector<double> errors;
  Score result;
  for (const Placed& tag : scene.tags) {
    for (const Found& d : detections) {
      if (static_cast<codec::TagId>(d.id) != tag.id ||
          length(d.center - tag.homography.project({0, 0})) > 3) {
        continue;
      }
      ++result.found;
      const Corners truth = testing::corners_of(tag.homography);
      for (int i = 0; i < 4; ++i) errors.push_back(length(d.corners[i] - truth[i]));
      break;
    }
  }
  std::sort(errors.begin(), errors.end());
  if (!errors.empty()) result.median_px = errors[errors.size() / 2];
  return result;
}

TEST(DetectorVsLibapriltag, FindsAsManyTagsInACrowdAndTheirCornersBetter) {
  // 1280 x 960 with 768 tags of 10 to 26 px.
  Scene scene = scene_of(32, 24, 40, 10, 26, 5);
  Peer peer;
  Detector detector({decoder()});
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto theirs = peer.detect(scene.image, false);
  const auto middle = Clock::now();
  DetectStats stats;
  const auto ours = detector.detect(scene.image, &stats);
  const auto end = Clock::now();
  const Score their_score = score(scene, theirs);
  const Score our_score = score(scene, ours);
  const auto ms = [](auto duration) {
    return std::chrono::duration<double, std::milli>(duration).count();
  };
  std::printf("          libapriltag   tagmint   of %zu tags\n", scene.tags.size());
  std::printf("found     %11d %9d\n", their_score.found, our_score.found);
  std::printf("median px %11.3f %9.3f\n", their_score.median_px, our_score.median_px);
  std::printf("ms        %11.1f %9.1f\n", ms(middle - start), ms(end - middle));
  for (int i = 0; i < kStages; ++i) {
    std::printf("  %-12s %6.1f ms\n", std::string(name_of(static_cast<Stage>(i))).c_str(),
                stats.stage_ms[i]);
  }
  EXPECT_GE(our_score.found, their_score.found);
  EXPECT_LT(our_score.median_px, their_score.median_px);
  EXPECT_EQ(ours.size(), static_cast<std::size_t>(our_score.found)) << "false detections";
}

}  // namespace
}  // namespace tagmint::detect
