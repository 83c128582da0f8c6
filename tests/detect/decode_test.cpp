#include <gtest/gtest.h>

#include <memory>

#include "pipeline/s7_decode.h"
#include "support/fixed_random.h"
#include "support/paint_tags.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::detect {
namespace {

using codec::Decoder;
using codec::Layout;
using testing::Canvas;
using testing::FixedRandom;

/// Data around a black border, unlike the presets, whose outer data is around a white one.
const char* const kBlackBorderInData = "ddddddd/dwwwwwd/dwbbbwd/dwbdbwd/dwbbbwd/dwwwwwd/ddddddd";

struct Case {
  const char* name;
  Layout layout;
};

std::vector<Case> layouts() {
  return {{"classic", codec::classic_layout(8)},
          {"standard", codec::standard_layout(9)},
          {"circle", codec::circle_layout(9)},
          {"hole", Layout("dddddddddd/dbbbbbbbbd/dbwwwwwwbd/dbwddddwbd/dbwdxxdwbd/dbwdxxdwbd/"
                          "dbwddddwbd/dbwwwwwwbd/dbbbbbbbbd/dddddddddd")},
          {"black border in data", Layout(kBlackBorderInData)}};
}

Decoder decoder_for(const Layout& layout) {
  return Decoder(testing::random_family("decode", layout, 5, 6));
}

/// Reads the quad whose corners are those of `upright`, begun at corner `first`.
DecodeResult decode_at(const Image& image, const Homography& upright, int first,
                       const Decoder& decoder, const DecodeOptions& options = {}) {
  const Corners corners = testing::corners_of(upright);
  Quad quad;
  for (int i = 0; i < 4; ++i) quad.corners[i] = corners[(i + first) % 4];
  quad.reversed_border = decoder.family()->layout().reversed_border();
  DecodeScratch scratch;
  return decode_quad(image, quad, decoder, options, scratch);
}

TEST(Decode, EveryLayoutFromEveryFirstCorner) {
  for (const auto& [name, layout] : layouts()) {
    const Decoder decoder = decoder_for(layout);
    const Homography truth = testing::tilted_square_at({80, 80}, 44, 0.5, 0.6, 1.0);
    for (codec::TagId id = 0; id < decoder.family()->size(); ++id) {
      Canvas canvas(160, 160, 120);
      testing::paint_tag(canvas, *decoder.family(), id, truth);
      FixedRandom random(1);
      const Image image = testing::to_gray(canvas, 2, random);
      for (int first = 0; first < 4; ++first) {
        const DecodeResult result = decode_at(image, truth, first, decoder);
        ASSERT_EQ(result.outcome, DecodeOutcome::Decoded) << name << " " << id << " " << first;
        const Detection& d = *result.detection;
        EXPECT_EQ(d.id, id) << name;
        EXPECT_EQ(d.hamming, 0) << name;
        const Corners corners = testing::corners_of(truth);
        for (int i = 0; i < 4; ++i) {
          EXPECT_LT(length(d.corners[i] - corners[i]), 1e-9) << name << " " << first;
          EXPECT_LT(length(d.homography.project(kTagCorners[i]) - corners[i]), 1e-9) << name;
        }
        EXPECT_LT(length(d.center - truth.project({0, 0})), 1e-9);
        EXPECT_DOUBLE_EQ(d.homography(2, 2), 1.0);
      }
    }
  }
}

TEST(Decode, MarginIsHalfTheContrastWithoutSharpening) {
  const Decoder decoder = decoder_for(codec::classic_layout(8));
  Canvas canvas(140, 140, 120);
  const Homography truth = testing::square_at({70, 70}, 72);
  testing::paint_tag(canvas, *decoder.family(), 0, truth, {.black = 50, .white = 150});
  FixedRandom random(1);
  const Image image = testing::to_gray(canvas, 0, random);
  const DecodeResult plain = decode_at(image, truth, 0, decoder, {.sharpening = 0});
  ASSERT_TRUE(plain.detection);
  EXPECT_NEAR(plain.detection->decision_margin, 50, 1);
  const DecodeResult sharp = decode_at(image, truth, 0, decoder);
  ASSERT_TRUE(sharp.detection);
  EXPECT_GT(sharp.detection->decision_margin, plain.detection->decision_margin);
  EXPECT_EQ(decode_at(image, truth, 0, decoder, {.min_decision_margin = 200}).outcome,
            DecodeOutcome::LowMargin);
}

TEST(Decode, LightThatFallsOffAcrossTheTagDoesNotMatter) {
  const Decoder decoder = decoder_for(codec::classic_layout(8));
  Canvas canvas(140, 140, 200);
  const Homography truth = testing::square_at({70, 70}, 90, 0.3);
  testing::paint_tag(canvas, *decoder.family(), 3, truth, {.black = 60, .white = 240});
  for (int y = 0; y < 140; ++y) {
    for (int x = 0; x < 140; ++x) canvas.at(x, y) *= static_cast<float>(0.15 + 0.85 * x / 140);
  }
  FixedRandom random(1);
  const DecodeResult result = decode_at(testing::to_gray(canvas, 1, random), truth, 0, decoder);
  ASSERT_TRUE(result.detection);
  EXPECT_EQ(result.detection->id, 3u);
  EXPECT_EQ(result.detection->hamming, 0);
}

TEST(Decode, SharpeningReadsATagThatBlurHidesOtherwise) {
  const Decoder decoder = decoder_for(codec::classic_layout(10));
  const Homography truth = testing::square_at({50, 50}, 24);  // 3 px a cell
  int with = 0, without = 0;
  for (codec::TagId id = 0; id < decoder.family()->size(); ++id) {
    Canvas canvas(100, 100, 200);
    testing::paint_tag(canvas, *decoder.family(), id, truth);
    testing::blur(canvas, 1.5);
    FixedRandom random(id);
    const Image image = testing::to_gray(canvas, 1, random);
    const DecodeOptions sharpening{.harder = false};
    const DecodeOptions none{.sharpening = 0, .harder = false};
    with += decode_at(image, truth, 0, decoder, sharpening).detection.has_value();
    without += decode_at(image, truth, 0, decoder, none).detection.has_value();
  }
  EXPECT_GT(with, without);
}

TEST(Decode, ColoursTheWrongWayRoundAreRefused) {
  const Decoder decoder = decoder_for(codec::classic_layout(8));
  Canvas canvas(140, 140, 120);
  const Homography truth = testing::square_at({70, 70}, 72);
  testing::paint_tag(canvas, *decoder.family(), 0, truth, {.black = 210, .white = 40});
  FixedRandom random(1);
  EXPECT_EQ(decode_at(testing::to_gray(canvas, 0, random), truth, 0, decoder).outcome,
            DecodeOutcome::NoContrast);
}

TEST(Decode, RingsOfNoiseAreNoBorder) {
  // 24 tags of 16 bits: a fifth of all words is within two bits of one.
  const Decoder decoder(testing::random_family("many", codec::classic_layout(8), 5, 24));
  ASSERT_EQ(decoder.max_errors(), 2);
  FixedRandom random(5);
  const Image noise = testing::to_gray(Canvas(400, 400, 128), 20, random);
  int decoded = 0, no_contrast = 0;
  for (int i = 0; i < 400; ++i) {
    const Point centre = {random.real(40, 360), random.real(40, 360)};
    const Homography place = testing::square_at(centre, random.real(12, 40), random.real(0, 3));
    const DecodeResult result = decode_at(noise, place, 0, decoder);
    decoded += result.outcome == DecodeOutcome::Decoded;
    no_contrast += result.outcome == DecodeOutcome::NoContrast;
  }
  EXPECT_EQ(decoded, 0);
  EXPECT_EQ(no_contrast, 400);
}

TEST(Decode, HardShadowsAndFaintTagsAreRead) {
  const Decoder decoder = decoder_for(codec::classic_layout(10));
  const Homography truth = testing::square_at({70, 70}, 72, 0.3);
  for (codec::TagId id = 0; id < decoder.family()->size(); ++id) {
    FixedRandom random(id);
    Canvas faint(140, 140, 130);
    testing::paint_tag(faint, *decoder.family(), id, truth, {.black = 100, .white = 120});
    EXPECT_TRUE(decode_at(testing::to_gray(faint, 5, random), truth, 0, decoder).detection) << id;
    Canvas shadow(140, 140, 200);
    testing::paint_tag(shadow, *decoder.family(), id, truth);
    for (int y = 0; y < 140; ++y) {
      for (int x = 0; x < 70; ++x) shadow.at(x, y) *= 0.5f;
    }
    EXPECT_NE(decode_at(testing::to_gray(shadow, 2, random), truth, 0, decoder).outcome,
              DecodeOutcome::NoContrast)
        << id;
  }
}

TEST(Decode, ABorderSquareOfOneCellIsRead) {
  const Decoder decoder = decoder_for(Layout("ddddd/dwwwd/dwbwd/dwwwd/ddddd"));
  const Homography truth = testing::square_at({70, 70}, 20, 0.3);
  for (codec::TagId id = 0; id < decoder.family()->size(); ++id) {
    Canvas canvas(140, 140, 120);
    testing::paint_tag(canvas, *decoder.family(), id, truth);
    FixedRandom random(1);
    const DecodeResult result = decode_at(testing::to_gray(canvas, 2, random), truth, 0, decoder);
    ASSERT_TRUE(result.detection) << id;
    EXPECT_EQ(result.detection->id, id);
  }
}

TEST(Decode, AWordThatIsNoTagsIsRefused) {
  const codec::SharedFamily all = testing::random_family("all", codec::classic_layout(8), 5, 6);
  const codec::SharedFamily other =
      testing::random_family("other", codec::classic_layout(8), 5, 1, 77);
  ASSERT_GT(codec::rotation_distance(all->codeword(0), other->codeword(0), 16), 2);
  Canvas canvas(140, 140, 120);
  const Homography truth = testing::square_at({70, 70}, 72);
  testing::paint_tag(canvas, *all, 0, truth);
  FixedRandom random(1);
  EXPECT_EQ(decode_at(testing::to_gray(canvas, 0, random), truth, 0, Decoder(other)).outcome,
            DecodeOutcome::NoCodeword);
}

TEST(Decode, DataCellsOutsideTheImageAreNeverReadAsBlack) {
  // standard:9 has data outside its border square; the image ends between the two.
  const Decoder decoder = decoder_for(codec::standard_layout(9));
  const Homography truth = testing::square_at({32, 60}, 60);
  Canvas canvas(140, 120, 200);
  testing::paint_tag(canvas, *decoder.family(), 2, truth);
  FixedRandom random(1);
  EXPECT_EQ(decode_at(testing::to_gray(canvas, 0, random), truth, 0, decoder).outcome,
            DecodeOutcome::OutsideImage);
}

TEST(Decode, CornersOnOneLineAreRefused) {
  const Decoder decoder = decoder_for(codec::classic_layout(8));
  const Image image(50, 50, 100);
  DecodeScratch scratch;
  const Quad flat{{{{10, 10}, {20, 10}, {30, 10}, {40, 10}}}, false};
  EXPECT_FALSE(decode_quad(image, flat, decoder, {}, scratch).detection);
}

}  // namespace
}  // namespace tagmint::detect
