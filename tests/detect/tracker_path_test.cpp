// The whole detector by the tracker: hard pictures, and what its result may not depend on.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <numbers>
#include <stdexcept>

#include "support/fixed_random.h"
#include "support/instruction_sets.h"
#include "support/paint_tags.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/detect/detector.h"

namespace {

/// Calls of operator new so far.
std::atomic<long> allocations = 0;

void* counted_memory(std::size_t size, std::size_t alignment) {
  ++allocations;
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, std::max(whole, alignment));
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return counted_memory(size, alignof(std::max_align_t)); }
void* operator new[](std::size_t size) { return counted_memory(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted_memory(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return counted_memory(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace tagmint::detect {
namespace {

using testing::Canvas;
using testing::FixedRandom;

std::shared_ptr<const codec::Decoder> decoder() {
  static const auto made = std::make_shared<const codec::Decoder>(codec::find_family("tag36h11"));
  return made;
}

/// What a grid of tags of tag36h11 is painted and photographed with.
struct GridOptions {
  int columns = 4;
  int rows = 3;
  double side_px = 40;
  double tilt_rad = 0;
  double blur_px = 0.6;
  double noise = 2;
  testing::Ink ink = {};
  double ground = 140;
};

struct Scene {
  Image image;
  std::vector<Homography> tags;  ///< tag i has id i
};

Scene grid(const GridOptions& options) {
  FixedRandom random(7);
  const int pitch = static_cast<int>(2.2 * options.side_px) + 8;
  Canvas canvas(options.columns * pitch, options.rows * pitch, static_cast<float>(options.ground));
  Scene scene;
  for (int i = 0; i < options.columns * options.rows; ++i) {
    const Point centre = {(i % options.columns + 0.5) * pitch + random.real(-2, 2),
                          (i / options.columns + 0.5) * pitch + random.real(-2, 2)};
    const Homography place =
        testing::tilted_square_at(centre, options.side_px, random.real(0, 2 * std::numbers::pi),
                                  options.tilt_rad, random.real(0, 2 * std::numbers::pi));
    testing::paint_tag(canvas, *decoder()->family(), static_cast<codec::TagId>(i), place,
                       options.ink);
    scene.tags.push_back(place);
  }
  if (options.blur_px > 0) testing::blur(canvas, options.blur_px);
  scene.image = testing::to_gray(canvas, options.noise, random);
  return scene;
}

/// How many tags were found in their places, and how many detections are none of them.
struct Count {
  int found = 0;
  int wrong = 0;
};

Count count_tags(const std::vector<Detection>& detections, const Scene& scene) {
  Count count;
  for (const Detection& d : detections) {
    const bool there =
        d.id < scene.tags.size() && length(d.center - scene.tags[d.id].project({0, 0})) < 3;
    ++(there ? count.found : count.wrong);
  }
  return count;
}

void expect_all(const GridOptions& options, int allowed_misses = 0) {
  const Scene scene = grid(options);
  Detector detector({decoder()});
  const Count count = count_tags(detector.detect(scene.image), scene);
  EXPECT_GE(count.found, static_cast<int>(scene.tags.size()) - allowed_misses);
  EXPECT_EQ(count.wrong, 0);
}

TEST(TrackerPath, EveryTagOf13PixelsIsFound) {
  expect_all({.columns = 12, .rows = 10, .side_px = 13, .blur_px = 0.5, .noise = 3});
}

TEST(TrackerPath, MostTagsOf10AndHalfOf9PixelsAreFound) {
  expect_all({.columns = 12, .rows = 10, .side_px = 10, .blur_px = 0.5, .noise = 3}, 12);
  expect_all({.columns = 12, .rows = 10, .side_px = 9, .blur_px = 0.5, .noise = 3}, 60);
}

TEST(TrackerPath, FaintTagsAreFound) {
  expect_all({.noise = 1, .ink = {.black = 124, .white = 132}, .ground = 128});
}

TEST(TrackerPath, TagsUnderStrongNoiseAreFound) {
  expect_all({.noise = 20});
  expect_all({.side_px = 50, .noise = 40}, 1);
}

TEST(TrackerPath, BlurredTagsAreFound) { expect_all({.side_px = 60, .blur_px = 2}); }

TEST(TrackerPath, SteepTagsAreFound) {
  expect_all({.side_px = 60, .tilt_rad = 75 * std::numbers::pi / 180});
  expect_all({.side_px = 80, .tilt_rad = 80 * std::numbers::pi / 180}, 1);
}

TEST(TrackerPath, LargeTagsOverManyBandsAreFound) {
  expect_all({.columns = 2, .rows = 1, .side_px = 700});
}

TEST(TrackerPath, TagsCutByThePicturesEdgeAreFound) {
  // The left fifth of a cell is not in the picture, nor is the paper beside it.
  for (const double cut_px : {0.0, 0.7, 1.4}) {
    Canvas canvas(80, 90, 140);
    testing::paint_tag(canvas, *decoder()->family(), 3, testing::square_at({28 - cut_px, 45}, 56));
    FixedRandom random(1);
    EXPECT_EQ(Detector({decoder()}).detect(testing::to_gray(canvas, 1, random)).size(), 1u)
        << cut_px;
  }
}

void expect_same(const std::vector<Detection>& a, const std::vector<Detection>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].id, b[i].id);
    EXPECT_EQ(a[i].hamming, b[i].hamming);
    EXPECT_EQ(a[i].decision_margin, b[i].decision_margin);
    EXPECT_EQ(a[i].corners, b[i].corners);
  }
}

/// Without the photometric step, which is not this path's.
DetectorOptions plain(int threads = 1) {
  DetectorOptions options;
  options.refine_photometric = false;
  options.threads = threads;
  return options;
}

TEST(TrackerPath, ThreadsDoNotChangeTheResult) {
  const Scene scene = grid({.columns = 6, .rows = 6, .side_px = 25, .noise = 6});
  DetectStats one_stats, four_stats;
  const auto one = Detector({decoder()}, plain(1)).detect(scene.image, &one_stats);
  const auto four = Detector({decoder()}, plain(4)).detect(scene.image, &four_stats);
  EXPECT_EQ(one.size(), 36u);
  expect_same(one, four);
  EXPECT_EQ(one_stats.starts, four_stats.starts);
  EXPECT_EQ(one_stats.shapes, four_stats.shapes);
  EXPECT_EQ(one_stats.bad_fit, four_stats.bad_fit);
}

TEST(TrackerPath, InstructionSetsDoNotChangeTheResult) {
  const Scene scene = grid({.columns = 5, .rows = 4, .side_px = 22, .noise = 5});
  const auto best = Detector({decoder()}, plain()).detect(scene.image);
  EXPECT_EQ(best.size(), 20u);
  testing::with_every_instruction_set(
      [&] { expect_same(best, Detector({decoder()}, plain()).detect(scene.image)); });
}

TEST(TrackerPath, AFrameTakesNoMemoryAfterTheFirst) {
  const Scene scene = grid({.columns = 6, .rows = 4, .side_px = 30, .noise = 4});
  Detector detector({decoder()}, plain());
  std::vector<Detection> detections;
  detector.detect(scene.image, detections);
  const long before = allocations;
  detector.detect(scene.image, detections);
  EXPECT_EQ(allocations, before);
  EXPECT_EQ(detections.size(), 24u);
}

TEST(TrackerPath, AnySizeWorksOrIsRefused) {
  Detector detector({decoder()});
  FixedRandom random(9);
  const Image noise = testing::to_gray(Canvas(300, 40, 128), 30, random);
  for (int width = 1; width <= 70; ++width) {
    for (const int height : {1, 2, 3, 5, 8, 13, 40}) {
      EXPECT_TRUE(detector.detect({noise.row(0), width, height, 300}).empty());
    }
  }
  // The largest sides, with one row of memory for all rows.
  const std::vector<std::uint8_t> row(Detector::kMaxSide_px, 77);
  EXPECT_TRUE(detector.detect({row.data(), Detector::kMaxSide_px, 9, 0}).empty());
  EXPECT_TRUE(detector.detect({row.data(), 9, Detector::kMaxSide_px, 0}).empty());
  EXPECT_THROW(detector.detect({row.data(), Detector::kMaxSide_px + 1, 9, 0}),
               std::invalid_argument);
  EXPECT_THROW(detector.detect({row.data(), 9, Detector::kMaxSide_px + 1, 0}),
               std::invalid_argument);
}

TEST(TrackerPath, SmallerTagsThanPromisedAreNotLookedFor) {
  const Scene scene = grid({.side_px = 20});
  DetectorOptions options = plain();
  options.min_side_px = 17;
  EXPECT_EQ(Detector({decoder()}, options).detect(scene.image).size(), 12u);
  options.min_side_px = 26;
  DetectStats stats;
  EXPECT_TRUE(Detector({decoder()}, options).detect(scene.image, &stats).empty());
  EXPECT_EQ(stats.quads, 0);
}

}  // namespace
}  // namespace tagmint::detect
