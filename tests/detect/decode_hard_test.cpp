// Reading what the plain way does not: blur, shadow, unusual prints; and believing what was read.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "decode/cell_evidence.h"
#include "pipeline/s7_decode.h"
#include "support/fixed_random.h"
#include "support/paint_tags.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/rotation.h"
#include "tagmint/detect/detector.h"

namespace tagmint::detect {
namespace {

using codec::Decoder;
using testing::Canvas;
using testing::FixedRandom;

Quad quad_of(const Corners& corners, bool reversed = false) { return {corners, reversed}; }

/// One for all tests: its table takes a while.
const Decoder& decoder_of_36h11() {
  static const Decoder decoder(codec::find_family("tag36h11"));
  return decoder;
}

/// How many of 40 tags of 36h11 are read, 40 px wide, with the picture blurred.
int read_through_blur(double sigma_px, bool harder) {
  const Decoder& decoder = decoder_of_36h11();
  DecodeScratch scratch;
  int read = 0;
  for (codec::TagId id = 0; id < 40; ++id) {
    FixedRandom random(id);
    Canvas canvas(90, 90, 130);
    const auto map = testing::square_at({45, 45}, 40, random.real(0, 6.28));
    testing::paint_tag(canvas, *decoder.family(), id, map);
    testing::blur(canvas, sigma_px);
    const Image image = testing::to_gray(canvas, 2, random);
    const DecodeResult result =
        decode_quad(image, quad_of(testing::corners_of(map)), decoder, {.harder = harder}, scratch);
    if (!result.detection) continue;
    EXPECT_EQ(result.detection->id, id);
    ++read;
  }
  return read;
}

TEST(DecodeHard, DeconvolutionReadsThroughBlur) {
  EXPECT_GE(read_through_blur(2, true), 39);
  const int through_three = read_through_blur(3, true);
  EXPECT_GE(through_three, 30);
  EXPECT_LT(read_through_blur(3, false), through_three);  // what it adds
}

TEST(DecodeHard, AHardShadowAcrossTheTagIsReadThrough) {
  const Decoder& decoder = decoder_of_36h11();
  DecodeScratch scratch;
  int read = 0, plain = 0;
  for (codec::TagId id = 0; id < 40; ++id) {
    FixedRandom random(id);
    Canvas canvas(120, 120, 130);
    const auto map = testing::square_at({60, 60}, 56, random.real(0, 6.28));
    testing::paint_tag(canvas, *decoder.family(), id, map, {.black = 30, .white = 220});
    const double angle = random.real(0, 6.28), offset = random.real(-15, 15);
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 120; ++x) {
        const bool shadow = (x - 60) * std::cos(angle) + (y - 60) * std::sin(angle) > offset;
        if (shadow) canvas.at(x, y) *= 0.45F;
      }
    }
    testing::blur(canvas, 0.7);
    const Image image = testing::to_gray(canvas, 2, random);
    const Quad quad = quad_of(testing::corners_of(map));
    const DecodeResult result = decode_quad(image, quad, decoder, {}, scratch);
    if (result.detection && result.detection->id == id) ++read;
    if (decode_quad(image, quad, decoder, {.harder = false}, scratch).detection) ++plain;
  }
  EXPECT_GE(read, 38);
  EXPECT_LT(plain, read);
}

/// One tag as printed, and what a detector says about it.
std::vector<Detection> detect_print(bool inverted, bool mirrored, const DetectorOptions& options,
                                    const std::string& name, Corners* truth = nullptr) {
  const codec::SharedFamily family = codec::find_family(name);
  Canvas canvas(170, 160, 130);
  const auto map = testing::square_at({84.2, 79.1}, 62, 0.35);
  const auto& h = map.row_major();
  const Homography seen =
      mirrored ? Homography({-h[0], h[1], h[2], -h[3], h[4], h[5], -h[6], h[7], h[8]}) : map;
  testing::Ink ink;
  if (inverted) std::swap(ink.black, ink.white);
  testing::paint_tag(canvas, *family, 6, seen, ink);
  testing::blur(canvas, 0.7);
  FixedRandom random(1);
  if (truth) {
    *truth = testing::corners_of(seen);
  }
  const Image image = testing::to_gray(canvas, 1, random);
  return Detector({std::make_shared<const Decoder>(family)}, options).detect(image);
}

TEST(UnusualPrints, AreFoundAndSaidToBeSoWhenAskedFor) {
  for (const Algorithm algorithm : {Algorithm::Tracker, Algorithm::Paper}) {
    DetectorOptions ask;
    ask.algorithm = algorithm;
    ask.report_inverted = ask.report_mirrored = true;
    for (const char* name : {"tag36h11", "tagStandard41h12"}) {
      for (const bool inverted : {false, true}) {
        for (const bool mirrored : {false, true}) {
          Corners truth;
          const auto found = detect_print(inverted, mirrored, ask, name, &truth);
          ASSERT_EQ(found.size(), 1U) << name << inverted << mirrored;
          EXPECT_EQ(found[0].id, 6U);
          EXPECT_EQ(found[0].inverted, inverted);
          EXPECT_EQ(found[0].mirrored, mirrored);
          EXPECT_TRUE(found[0].corner_covariance);
          for (int i = 0; i < 4; ++i) {
            EXPECT_LT(length(found[0].corners[i] - truth[i]), 0.05);
            EXPECT_LT(length(found[0].homography.project(kTagCorners[i]) - truth[i]), 0.05);
          }
        }
      }
    }
  }
}

TEST(UnusualPrints, AreNotFoundUnlessAskedFor) {
  EXPECT_TRUE(detect_print(true, false, {}, "tag36h11").empty());
  EXPECT_TRUE(detect_print(false, true, {}, "tag36h11").empty());
  DetectorOptions inverted_only;
  inverted_only.report_inverted = true;
  EXPECT_TRUE(detect_print(false, true, inverted_only, "tag36h11").empty());
  EXPECT_TRUE(detect_print(true, true, inverted_only, "tag36h11").empty());
}

TEST(Evidence, TellsATagFromGraysInABorder) {
  const codec::SharedFamily family = codec::find_family("tag16h5");
  const codec::Layout& layout = family->layout();
  const Decoder decoder(family);
  FixedRandom random(9);
  int believed = 0, tags_believed = 0, accepted = 0, tags = 0;
  std::vector<std::int8_t> colours;
  Whiteness cells;
  const auto size = static_cast<std::size_t>(layout.width() * layout.width());
  cells.known.assign(size, 1);
  cells.gray_levels.assign(size, 80);
  for (int round = 0; round < 4000; ++round) {
    const bool is_tag = round % 4 == 0;
    const auto id = static_cast<codec::TagId>(round % 30);
    cells.value.assign(size, -1);
    int bit = layout.bits();
    for (const codec::CellPosition p : layout.data_cells()) {
      const bool white = ((family->codeword(id) >> --bit) & 1) != 0;
      const double value = is_tag ? (white ? 1 : -1) + random.normal() * 0.2 : random.real(-1, 1);
      cells.value[p.y * layout.width() + p.x] = static_cast<float>(value);
    }
    const Reading reading = read_word(layout, cells, 0, {});
    const auto match = decoder.decode(reading.word);
    if (!match) continue;
    const codec::Codeword seen =
        codec::rotate(family->codeword(match->id), family->bits(), 4 - match->rotation);
    const double odds =
        log_odds(*family, match->hamming, cell_evidence(layout, cells, seen, {}, 0.1, colours), 1);
    if (is_tag) {
      ++tags;
      tags_believed += odds > 0;
    } else {
      ++accepted;
      believed += odds > 0;
    }
  }
  EXPECT_EQ(tags, 1000);
  EXPECT_GE(tags_believed, 990);
  EXPECT_GT(accepted, 500);            // every fourth word is near some tag of this family
  EXPECT_LT(believed, accepted / 10);  // most of them are not believed
}

TEST(DecodeFamilies, ReadFromOneGridWhatEachReadsAlone) {
  const auto first = std::make_shared<const Decoder>(codec::find_family("tag36h11"));
  const auto second = std::make_shared<const Decoder>(codec::find_family("tag36h10"));
  const auto third = std::make_shared<const Decoder>(codec::find_family("tag25h9"));
  FixedRandom random(2);
  DecodeScratch shared, alone;
  for (codec::TagId id = 0; id < 30; ++id) {
    const Decoder& painted = id % 3 == 0 ? *first : id % 3 == 1 ? *second : *third;
    Canvas canvas(90, 90, 130);
    const auto map = testing::square_at({45, 45}, 40, random.real(0, 6.28));
    testing::paint_tag(canvas, *painted.family(), id, map);
    const Image image = testing::to_gray(canvas, 3, random);
    const Quad quad = quad_of(testing::corners_of(map));
    start_quad(image, quad, shared);
    for (const auto& decoder : {first, second, third}) {
      const DecodeResult together = decode_family(*decoder, {}, shared);
      const DecodeResult by_itself = decode_quad(image, quad, *decoder, {}, alone);
      EXPECT_EQ(together.outcome, by_itself.outcome);
      if (decoder.get() == &painted) {
        ASSERT_TRUE(together.detection);
      }
      if (together.detection && by_itself.detection) {
        EXPECT_EQ(together.detection->id, by_itself.detection->id);
        EXPECT_EQ(together.detection->decision_margin, by_itself.detection->decision_margin);
        EXPECT_EQ(together.detection->log_odds, by_itself.detection->log_odds);
      }
    }
    EXPECT_EQ(shared.grids_in_use, 2U);  // tag36h11 and tag36h10 share one
  }
}

TEST(NestedTags, AreBothReported) {
  // tagCustom48h12 leaves two cells in its middle open; a tag of 36h11 is put there.
  const codec::SharedFamily host = codec::find_family("tagCustom48h12");
  const codec::SharedFamily guest = codec::find_family("tag36h11");
  Canvas canvas(700, 700, 180);
  const double side = 420;
  testing::paint_tag(canvas, *host, 9, testing::square_at({350, 350}, side));
  const double hole = side / host->layout().width_at_border() * 2;
  testing::paint_tag(canvas, *guest, 33, testing::square_at({350, 350}, hole * 0.8));
  testing::blur(canvas, 0.7);
  FixedRandom random(1);
  const Image image = testing::to_gray(canvas, 2, random);
  const auto found =
      Detector({std::make_shared<const Decoder>(host), std::make_shared<const Decoder>(guest)})
          .detect(image);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].id, 33U);
  EXPECT_EQ(found[1].id, 9U);
}

TEST(LargeFamilies, OfMillionsOfTagsAreFoundWithAllElse) {
  const codec::SharedFamily family = codec::find_family("rot48");
  ASSERT_GT(family->size(), 3'000'000U);
  const codec::TagId id = 3'456'789;
  Canvas canvas(200, 200, 130);
  const auto map = testing::square_at({101.3, 97.2}, 70, 1.1);
  testing::paint_tag(canvas, *family, id, map);
  testing::blur(canvas, 0.7);
  FixedRandom random(1);
  const auto found = Detector({std::make_shared<const Decoder>(family)})
                         .detect(testing::to_gray(canvas, 3, random));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].id, id);
  EXPECT_TRUE(found[0].corner_covariance);
}

}  // namespace
}  // namespace tagmint::detect
