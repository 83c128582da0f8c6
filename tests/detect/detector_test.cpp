#include "tagmint/detect/detector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "support/fixed_random.h"
#include "support/paint_tags.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::detect {
namespace {

using codec::Decoder;
using codec::Layout;
using codec::SharedFamily;
using testing::Canvas;
using testing::FixedRandom;

/// Random families are small and plain: with all errors corrected, some of their own cells would
/// pass for tags.
std::shared_ptr<const Decoder> decoder_of(const SharedFamily& family) {
  codec::DecoderOptions options;
  options.max_errors = 0;
  return std::make_shared<const Decoder>(family, options);
}

SharedFamily classic() {
  static const SharedFamily made =
      testing::random_family("classic", codec::classic_layout(10), 9, 16);
  return made;
}

struct Placed {
  SharedFamily family;
  codec::TagId id = 0;
  Homography pose;
};

struct Scene {
  Image image;
  std::vector<Placed> tags;
};

/// A grid of tags of random turns and tilts on a gray wall, slightly blurred, with noise.
Scene grid_of(const std::vector<SharedFamily>& families, int columns, int rows, double side_px,
              double noise = 2, double blur_px = 0.6, std::uint64_t seed = 7) {
  FixedRandom random(seed);
  const int pitch = static_cast<int>(2.6 * side_px) + 8;
  Canvas canvas(columns * pitch, rows * pitch, 140);
  Scene scene;
  for (int i = 0; i < columns * rows; ++i) {
    const SharedFamily& family = families[i % families.size()];
    const Point centre = {(i % columns + 0.5) * pitch + random.real(-2, 2),
                          (i / columns + 0.5) * pitch + random.real(-2, 2)};
    const Homography pose =
        testing::tilted_square_at(centre, side_px, random.real(0, 2 * std::numbers::pi),
                                  random.real(0, 0.6), random.real(0, 2 * std::numbers::pi));
    const auto id = static_cast<codec::TagId>((i / families.size()) % family->size());
    testing::paint_tag(canvas, *family, id, pose);
    scene.tags.push_back({family, id, pose});
  }
  testing::blur(canvas, blur_px);
  scene.image = testing::to_gray(canvas, noise, random);
  return scene;
}

/// The detection of a placed tag, or null.
const Detection* find(const std::vector<Detection>& detections, const Placed& tag) {
  for (const Detection& d : detections) {
    if (d.family == tag.family && d.id == tag.id &&
        length(d.center - tag.pose.project({0, 0})) < 3) {
      return &d;
    }
  }
  return nullptr;
}

/// Each tag is found once, and nothing else; returns the median corner error.
double expect_all_found(const std::vector<Detection>& detections, const Scene& scene) {
  EXPECT_EQ(detections.size(), scene.tags.size());
  std::vector<double> errors;
  for (const Placed& tag : scene.tags) {
    const Detection* found = find(detections, tag);
    EXPECT_NE(found, nullptr) << tag.family->name() << " " << tag.id;
    if (!found) continue;
    const Corners truth = testing::corners_of(tag.pose);
    for (int i = 0; i < 4; ++i) errors.push_back(length(found->corners[i] - truth[i]));
  }
  if (errors.empty()) return std::numeric_limits<double>::infinity();
  std::sort(errors.begin(), errors.end());
  return errors[errors.size() / 2];
}

std::vector<SharedFamily> one_family_of_each_kind() {
  const auto make = [](const char* name, const Layout& layout) {
    return testing::random_family(name, layout, 5, 8);
  };
  return {make("classic", codec::classic_layout(9)), make("standard", codec::standard_layout(9)),
          make("circle", codec::circle_layout(9)),
          make("custom", Layout("dddddddddd/dbbbbbbbbd/dbwwwwwwbd/dbwddddwbd/dbwdxxdwbd/"
                                "dbwdxxdwbd/dbwddddwbd/dbwwwwwwbd/dbbbbbbbbd/dddddddddd")),
          make("reversed", Layout("bbbbbbbbb/bwwwwwwwb/bwdddddwb/bwdddddwb/bwdddddwb/bwdddddwb/"
                                  "bwdddddwb/bwwwwwwwb/bbbbbbbbb"))};
}

TEST(Detector, FindsEveryKindOfLayout) {
  for (const SharedFamily& family : one_family_of_each_kind()) {
    const Scene scene = grid_of({family}, 3, 3, 48);
    Detector detector({decoder_of(family)});
    SCOPED_TRACE(family->name());
    EXPECT_LT(expect_all_found(detector.detect(scene.image), scene), 0.05);
  }
}

TEST(Detector, FindsSeveralFamiliesInOneImage) {
  const std::vector<SharedFamily> families = one_family_of_each_kind();
  const Scene scene = grid_of(families, 5, 3, 48);
  std::vector<std::shared_ptr<const Decoder>> decoders;
  for (const SharedFamily& family : families) decoders.push_back(decoder_of(family));
  Detector detector(decoders);
  EXPECT_LT(expect_all_found(detector.detect(scene.image), scene), 0.05);
}

TEST(Detector, CornersOfSmallTagsAreRightToATenthOfAPixel) {
  const Scene scene = grid_of({classic()}, 4, 4, 18);
  Detector detector({decoder_of(classic())});
  EXPECT_LT(expect_all_found(detector.detect(scene.image), scene), 0.1);
}

TEST(Detector, QuarterTurnsTurnTheCorners) {
  for (int turn = 0; turn < 4; ++turn) {
    Canvas canvas(120, 120, 150);
    const Homography pose = testing::square_at({60, 60}, 50, turn * std::numbers::pi / 2);
    testing::paint_tag(canvas, *classic(), 3, pose);
    FixedRandom random(1);
    const auto found =
        Detector({decoder_of(classic())}).detect(testing::to_gray(canvas, 1, random));
    ASSERT_EQ(found.size(), 1u) << turn;
    const Corners truth = testing::corners_of(pose);
    for (int i = 0; i < 4; ++i) {
      EXPECT_LT(length(found[0].corners[i] - truth[i]), 0.1) << turn << " " << i;
      EXPECT_LT(length(found[0].homography.project(kTagCorners[i]) - found[0].corners[i]), 1e-6);
    }
    if (turn == 0) {  // bottom left first, then counter-clockwise as seen
      EXPECT_LT(length(found[0].corners[0] - Point{35, 85}), 0.1);
      EXPECT_LT(length(found[0].corners[1] - Point{85, 85}), 0.1);
    }
  }
}

TEST(Detector, DecimatedSearchKeepsFullResolutionCorners) {
  const Scene scene = grid_of({classic()}, 3, 3, 60);
  for (const double decimate : {1.5, 2.0}) {
    Detector detector({decoder_of(classic())}, {.decimate = decimate});
    SCOPED_TRACE(decimate);
    EXPECT_LT(expect_all_found(detector.detect(scene.image), scene), 0.05);
  }
}

TEST(Detector, BlurredOrSharpenedSearchWorksToo) {
  const Scene scene = grid_of({classic()}, 3, 3, 48, 8);
  for (const double blur : {0.8, -0.8}) {
    Detector detector({decoder_of(classic())}, {.blur_sigma_px = blur});
    SCOPED_TRACE(blur);
    EXPECT_LT(expect_all_found(detector.detect(scene.image), scene), 0.1);
  }
}

void expect_same(const std::vector<Detection>& a, const std::vector<Detection>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].family, b[i].family);
    EXPECT_EQ(a[i].id, b[i].id);
    EXPECT_EQ(a[i].hamming, b[i].hamming);
    EXPECT_EQ(a[i].decision_margin, b[i].decision_margin);
    EXPECT_EQ(a[i].corners, b[i].corners);
    EXPECT_EQ(a[i].homography, b[i].homography);
  }
}

TEST(Detector, ThreadsDoNotChangeTheResult) {
  const Scene scene = grid_of(one_family_of_each_kind(), 5, 3, 30, 6);
  std::vector<std::shared_ptr<const Decoder>> decoders;
  for (const Placed& tag : scene.tags) {
    if (decoders.size() < 5) decoders.push_back(decoder_of(tag.family));
  }
  DetectStats one_stats, four_stats;
  const auto one = Detector(decoders, {.threads = 1}).detect(scene.image, &one_stats);
  const auto four = Detector(decoders, {.threads = 4}).detect(scene.image, &four_stats);
  const auto all = Detector(decoders, {.threads = 0}).detect(scene.image);
  EXPECT_GT(one.size(), 10u);
  expect_same(one, four);
  expect_same(one, all);
  EXPECT_EQ(one_stats.quads, four_stats.quads);
  EXPECT_EQ(one_stats.no_codeword, four_stats.no_codeword);
}

TEST(Detector, ADetectorUsedAgainGivesWhatANewOneGives) {
  const Scene large = grid_of({classic()}, 3, 2, 40, 2, 0.6, 1);
  const Scene small = grid_of({classic()}, 2, 1, 30, 2, 0.6, 2);
  Detector used({decoder_of(classic())});
  used.detect(large.image);
  expect_same(used.detect(small.image), Detector({decoder_of(classic())}).detect(small.image));
  expect_same(used.detect(large.image), Detector({decoder_of(classic())}).detect(large.image));
}

TEST(Detector, StridesOfAnyKindGiveTheSameResult) {
  const Scene scene = grid_of({classic()}, 2, 2, 40);
  const int width = scene.image.width();
  const int height = scene.image.height();
  const std::ptrdiff_t stride = width + 13;
  std::vector<std::uint8_t> padded(static_cast<std::size_t>(stride) * height, 99);
  std::vector<std::uint8_t> flipped = padded;
  for (int y = 0; y < height; ++y) {
    std::copy_n(scene.image.row(y), width, padded.begin() + y * stride);
    std::copy_n(scene.image.row(y), width, flipped.begin() + (height - 1 - y) * stride);
  }
  Detector detector({decoder_of(classic())});
  const auto plain = detector.detect(scene.image);
  EXPECT_EQ(plain.size(), 4u);
  expect_same(plain, detector.detect({padded.data(), width, height, stride}));
  expect_same(plain,
              detector.detect({flipped.data() + (height - 1) * stride, width, height, -stride}));
}

TEST(Detector, EmptyAndTinyImagesHaveNoTags) {
  Detector detector({decoder_of(classic())});
  EXPECT_TRUE(detector.detect(ImageView{}).empty());
  for (int height = 1; height <= 9; ++height) {
    for (int width = 1; width <= 9; ++width) {
      Image image(width, height, 200);
      image.at(width / 2, height / 2) = 10;
      EXPECT_TRUE(detector.detect(image).empty());
      EXPECT_TRUE(Detector({decoder_of(classic())}, {.decimate = 4}).detect(image).empty());
    }
  }
}

TEST(Detector, NoiseHoldsNoTags) {
  FixedRandom random(17);
  const Image image = testing::to_gray(Canvas(320, 240, 128), 30, random);
  DetectStats stats;
  EXPECT_TRUE(Detector({decoder_of(classic())}).detect(image).empty());
  Detector paper({decoder_of(classic())}, {.algorithm = Algorithm::Paper});
  EXPECT_TRUE(paper.detect(image, &stats).empty());
  EXPECT_GT(stats.boundary_points, 0);
}

TEST(Detector, ThePapersPathFindsTagsInNoiseOfAnyStrength) {
  for (const double noise : {0.0, 5.0, 10.0, 20.0, 35.0}) {
    const Scene scene = grid_of({classic()}, 4, 3, 60, noise);
    Detector paper({decoder_of(classic())}, {.algorithm = Algorithm::Paper});
    EXPECT_GE(paper.detect(scene.image).size(), noise > 20 ? 10u : 12u) << noise;
  }
}

TEST(Detector, NoiseCostsThePapersPathFewBoundariesUnlessTheFloorIsFixed) {
  const Scene scene = grid_of({classic()}, 4, 3, 60, 8);
  DetectStats follows, fixed;
  Detector({decoder_of(classic())}, {.algorithm = Algorithm::Paper}).detect(scene.image, &follows);
  Detector({decoder_of(classic())}, {.algorithm = Algorithm::Paper, .contrast_by_noise = false})
      .detect(scene.image, &fixed);
  EXPECT_LT(4 * follows.boundary_points, fixed.boundary_points);
  EXPECT_EQ(follows.detections, fixed.detections);
}

TEST(Detector, EachQuadIsAccountedFor) {
  const Scene scene = grid_of({classic()}, 3, 3, 40, 4);
  DetectStats stats;
  Detector detector({decoder_of(classic())});
  detector.detect(scene.image, &stats);
  EXPECT_EQ(stats.detections, 9);
  EXPECT_EQ(stats.quads, stats.outside_image + stats.no_contrast + stats.no_codeword +
                             stats.low_margin + stats.duplicates + stats.detections);
  for (const double ms : stats.stage_ms) EXPECT_GE(ms, 0);
}

/// Notes which pictures came, and in which order.
class Recorder : public DebugSink {
 public:
  std::string calls;
  std::size_t quads_seen = 0;
  std::vector<Corners> refined;

  void preprocessed(ImageView) override { calls += 'p'; }
  void threshold(ImageView) override { calls += 't'; }
  void components(std::span<const std::uint32_t> labels, int width, int height) override {
    calls += 's';
    EXPECT_EQ(labels.size(), static_cast<std::size_t>(width) * height);
  }
  void clusters(std::span<const Point> points, std::span<const std::size_t> begin) override {
    calls += 'c';
    ASSERT_FALSE(begin.empty());
    EXPECT_EQ(begin.back(), points.size());
  }
  void quads(std::span<const Corners> quads) override {
    calls += 'q';
    quads_seen = quads.size();
  }
  void refined_quads(std::span<const Corners> quads) override {
    calls += 'r';
    refined.assign(quads.begin(), quads.end());
  }
  void detections(std::span<const Detection>) override { calls += 'd'; }
};

TEST(Detector, DebuggingDoesNotChangeWhatThePapersPathFinds) {
  const Scene scene = grid_of({classic()}, 4, 3, 40, 4);
  Detector detector({decoder_of(classic())}, {.algorithm = Algorithm::Paper});
  DetectStats plain_stats, debug_stats;
  const auto plain = detector.detect(scene.image, &plain_stats);
  Recorder recorder;
  const auto debugged = detector.detect(scene.image, &debug_stats, &recorder);
  ASSERT_EQ(plain.size(), debugged.size());
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_EQ(plain[i].corners, debugged[i].corners);
  EXPECT_EQ(plain_stats.quads, debug_stats.quads);
}

TEST(Detector, TheDebugSinkTakesEachPictureOnceInOrder) {
  const Scene scene = grid_of({classic()}, 2, 1, 40);
  Recorder recorder;
  Detector detector({decoder_of(classic())}, {.decimate = 2, .refine_photometric = false});
  const auto found = detector.detect(scene.image, nullptr, &recorder);
  EXPECT_EQ(recorder.calls, "ptcqrd");
  EXPECT_EQ(recorder.refined.size(), recorder.quads_seen);
  ASSERT_EQ(found.size(), 2u);
  // Refined quads are full-resolution: each detection's corners are among them.
  for (const Detection& d : found) {
    EXPECT_TRUE(std::any_of(
        recorder.refined.begin(), recorder.refined.end(),
        [&](const Corners& c) { return std::find(c.begin(), c.end(), d.corners[0]) != c.end(); }));
  }
}

TEST(Detector, TheDebugSinkSeesTheComponentsOfThePapersPath) {
  const Scene scene = grid_of({classic()}, 2, 1, 40);
  Recorder recorder;
  Detector detector({decoder_of(classic())}, {.algorithm = Algorithm::Paper, .decimate = 2});
  detector.detect(scene.image, nullptr, &recorder);
  EXPECT_EQ(recorder.calls, "ptscqrd");
}

TEST(Detector, OneQuadIsOneTagWhateverTheFamiliesLookedFor) {
  // A fifth of all words is within two bits of a tag of the small family.
  const SharedFamily small = testing::random_family("small", codec::classic_layout(8), 5, 24);
  const Scene scene = grid_of({classic()}, 6, 5, 60);
  // Whatever little speaks for a reading, it is kept until the quad's readings are compared.
  Detector detector({std::make_shared<const Decoder>(small), decoder_of(classic())},
                    {.min_log_odds = -1000});
  DetectStats stats;
  const std::vector<Detection> found = detector.detect(scene.image, &stats);
  EXPECT_EQ(found.size(), scene.tags.size());
  for (const Detection& d : found) EXPECT_EQ(d.family, classic()) << d.id;
  EXPECT_GT(stats.duplicates, 0);
}

TEST(Detector, ImpossibleArgumentsAreRefused) {
  const auto decoder = decoder_of(classic());
  EXPECT_THROW(Detector({decoder}, {.min_log_odds = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(Detector({decoder}, {.lens = Camera{.fx = 0, .fy = 1}}), std::invalid_argument);
  EXPECT_THROW(Detector({}), std::invalid_argument);
  EXPECT_THROW(Detector({decoder, nullptr}), std::invalid_argument);
  EXPECT_THROW(Detector({decoder}, {.decimate = 0.5}), std::invalid_argument);
  EXPECT_THROW(Detector({decoder}, {.decimate = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(Detector({decoder}, {.blur_sigma_px = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(Detector({decoder}, {.blur_sigma_px = 1e9}), std::invalid_argument);
  EXPECT_THROW(Detector({decoder}, {.blur_sigma_px = -1e9}), std::invalid_argument);
  EXPECT_THROW(Detector({decoder}, {.min_side_px = 1e12}), std::invalid_argument);
  EXPECT_THROW(Detector({decoder}, {.min_contrast = 256}), std::invalid_argument);
  EXPECT_THROW(Detector({decoder}, {.max_corner_candidates = 3}), std::invalid_argument);
  EXPECT_THROW(Detector({decoder}, {.decode_sharpening = -1}), std::invalid_argument);
  EXPECT_THROW(Detector({decoder}, {.threads = -1}), std::invalid_argument);
  Detector fine({decoder});
  EXPECT_THROW(fine.detect({nullptr, 10, 10, 10}), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::detect
