// Prints how well cells are read by their size in pixels, for each kind of layout: the share of
// tags whose border is found and believed, and the share of wrong cells in those. docs/choose.md
// and tools/cli/reading_curve.cpp hold the figures.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "support/fixed_random.h"
#include "support/paint_tags.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/detect/detector.h"

namespace tagmint {
namespace {

constexpr int kPictures = 12;  // with one id each
constexpr int kColumns = 8;
constexpr int kTags = 48;  // a picture
constexpr double kBlur_px = 0.5;
constexpr double kNoise = 5;

/// Border square of tag `i` of a picture, somewhere about the middle of its place in a grid.
detect::Homography place_of(int i, double side_px, double pitch_px, testing::FixedRandom& random) {
  const detect::Point centre{(i % kColumns + 0.5) * pitch_px + random.real(-0.5, 0.5),
                             (i / kColumns + 0.5) * pitch_px + random.real(-0.5, 0.5)};
  return testing::square_at(centre, side_px, random.real(0, 2 * std::numbers::pi));
}

/// What became of all tags of one size.
struct Readings {
  int tags = 0;
  std::vector<int> errors;  ///< wrong cells of each tag that was found
};

/// One picture: 48 times the same tag, frontal, turned at random. The decoder knows that tag alone
/// and takes any number of errors, so `hamming` counts the wrong cells.
void read_picture(const codec::SharedFamily& family, codec::TagId id, double cell_px,
                  testing::FixedRandom& random, Readings& readings) {
  const codec::Layout& layout = family->layout();
  const double side_px = layout.width_at_border() * cell_px;
  const double pitch_px = 1.45 * (layout.width() + 2) * cell_px + 8;
  testing::Canvas canvas(static_cast<int>(kColumns * pitch_px),
                         static_cast<int>(kTags / kColumns * pitch_px), 130);
  std::vector<detect::Point> centres;
  for (int i = 0; i < kTags; ++i) {
    const detect::Homography place = place_of(i, side_px, pitch_px, random);
    testing::paint_tag(canvas, *family, id, place);
    centres.push_back(place.project({0, 0}));
  }
  testing::blur(canvas, kBlur_px);
  const detect::Image image = testing::to_gray(canvas, kNoise, random);
  detect::Detector detector({std::make_shared<const codec::Decoder>(
      family, codec::DecoderOptions{.max_errors = family->bits() / 2,
                                    .allow_unsafe_radius = true,
                                    .engine = codec::DecoderEngine::BruteForce,
                                    .ids = {id}})});
  readings.tags += kTags;
  const std::vector<detect::Detection> found = detector.detect(image);
  for (const detect::Point& centre : centres) {
    const auto at = std::find_if(found.begin(), found.end(), [&](const detect::Detection& d) {
      return length(d.center - centre) < side_px / 4;
    });
    if (at != found.end()) readings.errors.push_back(at->hamming);
  }
}

double mean_of(std::span<const int> values) {
  double sum = 0;
  for (const int value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

void print_layout(const std::string& name) {
  const codec::Layout layout = codec::parse_layout(name);
  const codec::SharedFamily family =
      testing::random_family("random", layout, layout.bits() / 4, kPictures);
  fmt::print("\n{}: {} bits, {} cells at the border\n", name.substr(0, 20), layout.bits(),
             layout.width_at_border());
  fmt::print("cell px,border found,wrong cells,errors 0,<=1,<=2,<=3,<=5,<=8\n");
  for (const double cell_px : {0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.8, 2.0, 2.4, 3.0}) {
    testing::FixedRandom random(11);
    Readings readings;
    for (int i = 0; i < kPictures; ++i) {
      read_picture(family, static_cast<codec::TagId>(i), cell_px, random, readings);
    }
    fmt::print("{},{:.3f},{:.4f}", cell_px,
               static_cast<double>(readings.errors.size()) / readings.tags,
               mean_of(readings.errors) / layout.bits());
    for (const int most : {0, 1, 2, 3, 5, 8}) {
      const auto within = std::count_if(readings.errors.begin(), readings.errors.end(),
                                        [&](int errors) { return errors <= most; });
      fmt::print(",{:.3f}", static_cast<double>(within) / readings.tags);
    }
    fmt::print("\n");
  }
}

}  // namespace
}  // namespace tagmint

int main(int count, char** words) {
  std::vector<std::string> layouts(words + 1, words + count);
  if (layouts.empty())
    layouts = {"classic:8",  "classic:9",   "classic:10", "classic:12",
               "standard:9", "standard:10", "circle:9",   "circle:11"};
  for (const std::string& layout : layouts) tagmint::print_layout(layout);
}
