#include "tagmint/detect/pose.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "support/fixed_random.h"

namespace tagmint::detect {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kEdge = 0.1;
const Camera kCamera{.fx = 800, .fy = 810, .cx = 322, .cy = 241};
const Camera kLens{
    .fx = 800, .fy = 810, .cx = 322, .cy = 241, .k1 = -0.2, .k2 = 0.05, .p1 = 0.001, .p2 = -0.002};

struct Truth {
  Matrix3d R;
  Vector3d t;
};

Matrix3d rotation_of(const Pose& pose) {
  Matrix3d R;
  for (int i = 0; i < 9; ++i) R(i / 3, i % 3) = pose.R[i];
  return R;
}

/// Leaning by `tilt` about a direction in the tag plane, after a turn by `roll`.
Truth looking_at(double tilt, double axis, double roll, const Vector3d& t) {
  const Vector3d lean_axis(std::cos(axis), std::sin(axis), 0);
  return {(AngleAxisd(tilt, lean_axis) * AngleAxisd(roll, Vector3d::UnitZ())).toRotationMatrix(),
          t};
}

Corners seen(const Truth& truth, const Camera& camera) {
  Corners corners;
  for (int i = 0; i < 4; ++i) {
    const Vector3d p =
        truth.R * Vector3d(kTagCorners[i].x, kTagCorners[i].y, 0) * (kEdge / 2) + truth.t;
    corners[i] = camera.to_pixel({p.x() / p.z(), p.y() / p.z()});
  }
  return corners;
}

double angle_deg(const Matrix3d& a, const Matrix3d& b) {
  return AngleAxisd(a.transpose() * b).angle() / kDegree;
}

double distance_mm(const Pose& pose, const Truth& truth) {
  return (Vector3d(pose.t[0], pose.t[1], pose.t[2]) - truth.t).norm() * 1000;
}

TEST(Pose, FrontalUprightTagHasTheIdentityRotation) {
  const Truth truth{Matrix3d::Identity(), {0, 0, 0.5}};
  const auto estimate = estimate_pose(seen(truth, kCamera), kCamera, kEdge);
  ASSERT_TRUE(estimate);
  EXPECT_LT(angle_deg(rotation_of(estimate->best), truth.R), 1e-3);
  EXPECT_LT(distance_mm(estimate->best, truth), 1e-3);
}

TEST(Pose, ExactCornersGiveTheTruthOverAllTilts) {
  for (const Camera& camera : {kCamera, kLens}) {
    for (double tilt = 5; tilt <= 80; tilt += 5) {
      for (double axis = 0; axis < 360; axis += 45) {
        const Truth truth = looking_at(tilt * kDegree, axis * kDegree, 0.4, {0.05, -0.03, 0.6});
        const auto estimate = estimate_pose(seen(truth, camera), camera, kEdge);
        ASSERT_TRUE(estimate) << tilt << " deg";
        EXPECT_LT(angle_deg(rotation_of(estimate->best), truth.R), 1e-4) << tilt << " deg";
        EXPECT_LT(distance_mm(estimate->best, truth), 1e-4) << tilt << " deg";
        EXPECT_LT(estimate->best.error, 1e-14);
      }
    }
  }
}

TEST(Pose, AFlatTagFarAwayHasTwoPosesOrderedByError) {
  // Seen along the line of sight, the other pose leans the other way by about the same angle.
  const Truth truth = looking_at(30 * kDegree, 0, 0, {0, 0, 2.0});
  const auto estimate = estimate_pose(seen(truth, kCamera), kCamera, kEdge);
  ASSERT_TRUE(estimate);
  ASSERT_TRUE(estimate->alternative);
  EXPECT_LE(estimate->best.error, estimate->alternative->error);
  const Truth mirrored = looking_at(-30 * kDegree, 0, 0, {0, 0, 2.0});
  EXPECT_LT(angle_deg(rotation_of(estimate->alternative.value()), mirrored.R), 3.0);
}

TEST(Pose, BothPosesAreLocalMinimaOfTheError) {
  const Truth truth = looking_at(35 * kDegree, 0.7, 0.3, {0.1, 0.05, 1.5});
  const auto estimate = estimate_pose(seen(truth, kCamera), kCamera, kEdge);
  ASSERT_TRUE(estimate && estimate->alternative);
  // The object-space error, written out again.
  const auto error = [&](const Matrix3d& R, const Vector3d& t) {
    const Corners corners = seen(truth, kCamera);
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
      const Point n = kCamera.to_normalised(corners[i]);
      const Vector3d v = Vector3d(n.x, n.y, 1).normalized();
      const Vector3d q = R * Vector3d(kTagCorners[i].x, kTagCorners[i].y, 0) * (kEdge / 2) + t;
      sum += (q - v * v.dot(q)).squaredNorm();
    }
    return sum / 4;
  };
  for (const Pose& pose : {estimate->best, *estimate->alternative}) {
    const Matrix3d R = rotation_of(pose);
    const Vector3d t(pose.t[0], pose.t[1], pose.t[2]);
    EXPECT_NEAR(error(R, t), pose.error, 1e-15);
    for (int i = 0; i < 3; ++i) {
      for (const double step : {-1e-3, 1e-3}) {
        EXPECT_GT(error(AngleAxisd(step, Vector3d::Unit(i)) * R, t), pose.error);
        EXPECT_GT(error(R, t + step * Vector3d::Unit(i)), pose.error);
      }
    }
  }
}

TEST(Pose, NoisyCornersStayNearTheTruth) {
  // 0.05 px of noise on a side of 130 px at 0.6 m: a few tenths of a degree when tilted.
  testing::FixedRandom random(11);
  std::vector<double> degrees, millimetres;
  for (int trial = 0; trial < 200; ++trial) {
    const Truth truth = looking_at(random.real(20, 65) * kDegree, random.real(0, 6),
                                   random.real(-3, 3), {0.03, 0.02, 0.6});
    Corners corners = seen(truth, kLens);
    for (Point& p : corners) p = p + Point{0.05 * random.normal(), 0.05 * random.normal()};
    const auto estimate = estimate_pose(corners, kLens, kEdge);
    ASSERT_TRUE(estimate);
    degrees.push_back(angle_deg(rotation_of(estimate->best), truth.R));
    millimetres.push_back(distance_mm(estimate->best, truth));
  }
  std::sort(degrees.begin(), degrees.end());
  std::sort(millimetres.begin(), millimetres.end());
  EXPECT_LT(degrees[100], 0.2);
  EXPECT_LT(degrees[190], 0.8);
  EXPECT_LT(millimetres[100], 0.4);
}

TEST(Pose, DegenerateCornersHaveNone) {
  EXPECT_FALSE(estimate_pose({{{10, 10}, {20, 10}, {30, 10}, {40, 10}}}, kCamera, kEdge));
  EXPECT_FALSE(estimate_pose({{{10, 10}, {10, 10}, {10, 10}, {10, 10}}}, kCamera, kEdge));
}

TEST(Pose, NeverBehindTheCamera) {
  // Corners of no square at all must give a pose in front of the camera or none.
  testing::FixedRandom random(5);
  for (int trial = 0; trial < 300; ++trial) {
    Corners corners;
    for (Point& p : corners) p = {random.real(0, 640), random.real(0, 480)};
    const auto estimate = estimate_pose(corners, kCamera, kEdge);
    if (!estimate) continue;
    EXPECT_GT(estimate->best.t[2], 0);
    EXPECT_TRUE(std::isfinite(estimate->best.error));
    if (estimate->alternative) {
      EXPECT_GT(estimate->alternative->t[2], 0);
    }
  }
}

TEST(Pose, ImpossibleArgumentsAreRefused) {
  const Corners corners = seen({Matrix3d::Identity(), {0, 0, 0.5}}, kCamera);
  EXPECT_THROW(estimate_pose(corners, kCamera, 0), std::invalid_argument);
  EXPECT_THROW(estimate_pose(corners, kCamera, std::numeric_limits<double>::infinity()),
               std::invalid_argument);
  EXPECT_THROW(estimate_pose(corners, Camera{}, kEdge), std::invalid_argument);
}

/// Corners with noise of a covariance that is neither even nor without correlations.
struct NoisyCorners {
  Corners corners;
  CornerCovariance covariance{};
};

double normal(testing::FixedRandom& random) { return random.normal(); }

NoisyCorners with_noise(const Corners& truth, double sigma_px, testing::FixedRandom& random) {
  // Every corner by itself, and all together as a shift and a growth.
  Eigen::Matrix<double, 8, 11> causes = Eigen::Matrix<double, 8, 11>::Zero();
  Point middle{0, 0};
  for (const Point p : truth) middle = middle + 0.25 * p;
  for (int i = 0; i < 8; ++i) {
    causes(i, i) = sigma_px;
    causes(i, 8 + i % 2) = 0.5 * sigma_px;
    const Point out = truth[i / 2] - middle;
    causes(i, 10) = 0.7 * sigma_px * (i % 2 == 0 ? out.x : out.y) / length(out);
  }
  Eigen::Matrix<double, 11, 1> draw;
  for (int i = 0; i < 11; ++i) draw(i) = normal(random);
  const Eigen::Matrix<double, 8, 1> off = causes * draw;
  const Eigen::Matrix<double, 8, 8> covariance = causes * causes.transpose();
  NoisyCorners noisy{truth};
  for (int i = 0; i < 8; ++i) {
    (i % 2 == 0 ? noisy.corners[i / 2].x : noisy.corners[i / 2].y) += off(i);
    for (int j = 0; j < 8; ++j) noisy.covariance[i * 8 + j] = covariance(i, j);
  }
  return noisy;
}

/// Turn and shift from a pose to the truth, in the units of Pose::covariance.
Eigen::Matrix<double, 6, 1> error_of(const Pose& pose, const Truth& truth) {
  const AngleAxisd turn(truth.R * rotation_of(pose).transpose());
  Eigen::Matrix<double, 6, 1> error;
  error << turn.angle() * turn.axis(), truth.t - Vector3d(pose.t[0], pose.t[1], pose.t[2]);
  return error;
}

TEST(PoseCovariance, IsWhatTheErrorsSay) {
  for (const Camera& camera : {kCamera, kLens}) {
    for (const double sigma : {0.01, 0.05, 0.2}) {
      testing::FixedRandom random(17);
      double sum = 0;
      double chi_squared = 0;
      constexpr int kRounds = 500;
      for (int round = 0; round < kRounds; ++round) {
        const Truth truth = looking_at(random.real(30, 60) * kDegree, random.real(0, 6.28),
                                       random.real(0, 6.28), {0.05, -0.03, 0.7});
        const NoisyCorners noisy = with_noise(seen(truth, camera), sigma, random);
        const auto estimate = estimate_pose(noisy.corners, camera, kEdge, noisy.covariance);
        ASSERT_TRUE(estimate);
        ASSERT_TRUE(estimate->best.covariance);
        const Eigen::Matrix<double, 6, 6> covariance =
            Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(
                estimate->best.covariance->data());
        const Eigen::Matrix<double, 6, 1> error = error_of(estimate->best, truth);
        sum += error.dot(covariance.ldlt().solve(error)) / 6;
        chi_squared += *estimate->best.chi_squared / 2;
      }
      // Of 500 draws with six degrees of freedom the mean has a deviation of 0.026.
      EXPECT_NEAR(sum / kRounds, 1, 0.1) << sigma;
      EXPECT_NEAR(chi_squared / kRounds, 1, 0.15) << sigma;
    }
  }
}

TEST(PoseCovariance, MakesThePoseTruerWhereCornersAreNotAlike) {
  testing::FixedRandom random(3);
  double with = 0, without = 0;
  for (int round = 0; round < 200; ++round) {
    const Truth truth =
        looking_at(45 * kDegree, random.real(0, 6.28), random.real(0, 6.28), {0, 0, 0.7});
    Corners corners = seen(truth, kCamera);
    CornerCovariance covariance{};
    for (int i = 0; i < 8; ++i) covariance[i * 9] = i < 2 ? 1.0 : 1e-4;
    corners[0] = corners[0] + Point{normal(random), normal(random)};  // a corner that nobody saw
    const auto weighed = estimate_pose(corners, kCamera, kEdge, covariance);
    const auto plain = estimate_pose(corners, kCamera, kEdge);
    ASSERT_TRUE(weighed && plain);
    with += angle_deg(rotation_of(weighed->best), truth.R);
    without += angle_deg(rotation_of(plain->best), truth.R);
  }
  EXPECT_LT(with, without / 5);
}

TEST(PoseAmbiguity, IsTheShareOfWrongChoices) {
  // Small tags far away, nearly frontal: which of the two leans is the true one often cannot be
  // seen.
  testing::FixedRandom random(23);
  double expected_wrong = 0;
  int wrong = 0, both = 0, ambiguous = 0, wrong_though_clear = 0;
  for (int round = 0; round < 1500; ++round) {
    const Truth truth = looking_at(random.real(5, 40) * kDegree, random.real(0, 6.28),
                                   random.real(0, 6.28), {0.1, 0, random.real(2, 6)});
    const NoisyCorners noisy = with_noise(seen(truth, kCamera), 0.05, random);
    const auto estimate = estimate_pose(noisy.corners, kCamera, kEdge, noisy.covariance);
    ASSERT_TRUE(estimate);
    if (!estimate->alternative) continue;
    ++both;
    ASSERT_TRUE(estimate->alternative_probability);
    EXPECT_LE(*estimate->best.chi_squared, *estimate->alternative->chi_squared);
    const bool is_wrong = angle_deg(rotation_of(estimate->alternative.value()), truth.R) <
                          angle_deg(rotation_of(estimate->best), truth.R);
    expected_wrong += *estimate->alternative_probability;
    wrong += is_wrong;
    ambiguous += estimate->ambiguous();
    wrong_though_clear += is_wrong && !estimate->ambiguous();
  }
  EXPECT_GT(both, 1000);
  EXPECT_GT(wrong, 20);
  EXPECT_NEAR(wrong, expected_wrong, 0.3 * expected_wrong);
  EXPECT_GT(ambiguous, wrong);
  EXPECT_LT(wrong_though_clear, 0.01 * both);
}

TEST(PoseAmbiguity, IsNotToldWithoutACovariance) {
  const auto estimate =
      estimate_pose(seen(looking_at(0.2, 1, 0, {0, 0, 2}), kCamera), kCamera, kEdge);
  ASSERT_TRUE(estimate);
  EXPECT_FALSE(estimate->alternative_probability);
  EXPECT_FALSE(estimate->best.covariance);
  EXPECT_FALSE(estimate->ambiguous());
}

}  // namespace
}  // namespace tagmint::detect
