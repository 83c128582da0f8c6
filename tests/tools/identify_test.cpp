// Which tag is this picture, and what became of it on the way?
#include "identify/identify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "io/family_kinds/older_systems.h"
#include "support/fixed_random.h"
#include "support/paint_tags.h"
#include "support/tag_pictures.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::test {
namespace {

using codec::SharedFamily;
using codec::TagId;
using detect::Image;
using identify::BorderPart;
using identify::Candidate;
using identify::Identification;
using identify::Identifier;

std::vector<SharedFamily> all_families() {
  std::vector<SharedFamily> families;
  for (const std::string& name : codec::family_names()) {
    families.push_back(codec::find_family(name));
  }
  for (const std::string& name : io::older_system_names()) {
    families.push_back(
        std::make_shared<const codec::Family>(io::find_older_system(name, {})->family));
  }
  return families;
}

/// What became of a print.
struct Variant {
  bool mirrored = false;
  int quarters = 0;  ///< turned clockwise, after the mirror
  bool inverted = false;
};

std::vector<Variant> all_variants() {
  std::vector<Variant> variants;
  for (const bool mirror : {false, true}) {
    for (int quarters = 0; quarters < 4; ++quarters) {
      for (const bool invert : {false, true}) variants.push_back({mirror, quarters, invert});
    }
  }
  return variants;
}

Image varied(Image picture, const Variant& variant) {
  if (variant.mirrored) picture = mirrored(picture);
  picture = turned(picture, variant.quarters);
  return variant.inverted ? inverted(picture) : picture;
}

/// Distance of two angles, degrees.
double angle_between(double a, double b) {
  const double difference = std::fmod(std::abs(a - b), 360);
  return std::min(difference, 360 - difference);
}

/// Tags of all families, the older systems included. One for the whole program: its tables are made
/// once.
class Identify : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    families = all_families();
    identifier = std::make_unique<Identifier>(families, 1);
  }
  static void TearDownTestSuite() {
    identifier.reset();
    families.clear();
  }

  static const SharedFamily& family(const std::string& name) {
    return *std::find_if(families.begin(), families.end(),
                         [&](const SharedFamily& f) { return f->name() == name; });
  }

  /// The families whose tags carry enough for a single word to be no accident.
  static std::vector<SharedFamily> telling_families() {
    std::vector<SharedFamily> telling;
    for (const SharedFamily& f : families) {
      // All 2^13 patterns, and 2^9 of them, are tags of these two.
      if (f->name() != "artoolkit-4x4" && f->name() != "artoolkit-4x4-bch-13-9-3") {
        telling.push_back(f);
      }
    }
    return telling;
  }

  static std::vector<TagId> some_ids(const codec::Family& f) {
    const auto last = static_cast<TagId>(f.size() - 1);
    return {0, last / 2, last};
  }

  /// Expects one tag in the picture, and among what it may be this one.
  static void expect_tag(const Image& picture, const SharedFamily& f, TagId id,
                         const Variant& variant, BorderPart border, double turned_deg,
                         double tolerance_deg = 0.1) {
    SCOPED_TRACE(f->name() + " id " + std::to_string(id) + (variant.mirrored ? " mirrored" : "") +
                 (variant.inverted ? " inverted" : "") + " turned " + std::to_string(turned_deg) +
                 ", " + std::to_string(picture.width()) + " px");
    const Identification found = identifier->identify(picture);
    ASSERT_EQ(found.tags.size(), 1u);
    EXPECT_FALSE(found.nearest);
    const auto& candidates = found.tags.front();
    const auto right = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& c) {
      return c.family == f && c.id == id && c.mirrored == variant.mirrored;
    });
    ASSERT_NE(right, candidates.end());
    EXPECT_EQ(right->hamming, 0);
    EXPECT_EQ(right->inverted, variant.inverted);
    EXPECT_EQ(right->border, border);
    // Some tags of the oldest systems look the same after half a turn.
    if (f->max_safe_errors() > 0) {
      EXPECT_LE(angle_between(right->turned_deg, turned_deg), tolerance_deg);
    }
  }

  static std::vector<SharedFamily> families;
  static std::unique_ptr<Identifier> identifier;
};
std::vector<SharedFamily> Identify::families;
std::unique_ptr<Identifier> Identify::identifier;

TEST_F(Identify, ReadsOnePixelACellAndMoreOfEveryFamilyInEveryVariant) {
  for (const SharedFamily& f : telling_families()) {
    for (const TagId id : some_ids(*f)) {
      const Image one_pixel = print_tag(*f, id);
      const Image three_pixels = print_tag(*f, id, {.cell_px = 3, .quiet_cells = 2});
      for (const Variant& variant : all_variants()) {
        expect_tag(varied(one_pixel, variant), f, id, variant, BorderPart::Whole,
                   90.0 * variant.quarters);
      }
      const Variant odd{true, static_cast<int>(id % 4), true};
      expect_tag(varied(three_pixels, odd), f, id, odd, BorderPart::Whole, 90.0 * odd.quarters);
    }
  }
}

TEST_F(Identify, ReadsPrintsWithoutTheirWhiteRing) {
  for (const SharedFamily& f : telling_families()) {
    if (f->layout().cell(0, 0) != codec::Cell::White) continue;
    const auto id = static_cast<TagId>(f->size() / 3);
    for (const int cell_px : {1, 4, 12}) {
      const Image cut = print_tag(*f, id, {.cell_px = cell_px, .quiet_cells = -1});
      for (const Variant& variant : {Variant{}, Variant{true, 1, true}, Variant{false, 3, true}}) {
        expect_tag(varied(cut, variant), f, id, variant, BorderPart::Cut, 90.0 * variant.quarters);
      }
    }
  }
}

TEST_F(Identify, ReadsTheDataCellsWithoutAnyBorder) {
  for (const char* name : {"tag25h9", "tag36h11", "tag36h10", "rot36", "rot64", "aruco-original",
                           "artoolkitplus-bch"}) {
    const SharedFamily& f = family(name);
    const auto id = static_cast<TagId>(f->size() / 2);
    for (const int cell_px : {1, 2, 10}) {
      const Image cells = print_tag(*f, id, {.cell_px = cell_px, .quiet_cells = -2});
      for (const Variant& variant : {Variant{}, Variant{true, 2, false}, Variant{false, 1, true}}) {
        expect_tag(varied(cells, variant), f, id, variant, BorderPart::None,
                   90.0 * variant.quarters);
      }
    }
  }
}

/// A tag as a camera sees it: turned, tilted, blurred, noisy.
Image photograph(const codec::Family& f, TagId id, double side_px, double angle_rad,
                 testing::FixedRandom& random) {
  const int size = static_cast<int>(side_px * 2.6);
  testing::Canvas canvas(size, size, 120);
  testing::paint_tag(
      canvas, f, id,
      testing::tilted_square_at({size / 2.0, size / 2.0}, side_px, angle_rad, 0.3, 1.0));
  testing::blur(canvas, 0.6);
  return testing::to_gray(canvas, 3, random);
}

TEST_F(Identify, ReadsPhotographsOfEveryFamilyAndTheAngle) {
  testing::FixedRandom random(7);
  int number = 0;
  for (const SharedFamily& f : telling_families()) {
    for (const TagId id : some_ids(*f)) {
      // A word of 16 bits says little: a photograph of one that is mirrored may be an accident.
      const Variant variant =
          f->bits() == 16 ? Variant{} : all_variants()[static_cast<std::size_t>(number % 16)];
      const double angle = 0.4 + 1.3 * number++;
      const double side_px = (number % 3 == 0 ? 12 : 4) * f->layout().width_at_border();
      Image picture = photograph(*f, id, side_px, angle, random);
      if (variant.mirrored) picture = mirrored(picture);
      if (variant.inverted) picture = inverted(picture);
      const double turn = angle * 180 / std::numbers::pi;
      // The tilt changes angles by up to three degrees.
      expect_tag(picture, f, id, variant, BorderPart::Whole, variant.mirrored ? -turn : turn, 4);
    }
  }
}

TEST_F(Identify, ReadsATagOfFourMegapixels) {
  const SharedFamily& f = family("tagStandard41h12");
  expect_tag(print_tag(*f, 99, {.cell_px = 200, .quiet_cells = 1}), f, 99, {}, BorderPart::Whole,
             0);
}

TEST_F(Identify, TellsAllFamiliesThatShareATagTheSmallestFirst) {
  const Identification found = identifier->identify(print_tag(*family("tag36h9"), 1000));
  ASSERT_EQ(found.tags.size(), 1u);
  const auto& candidates = found.tags.front();
  ASSERT_GE(candidates.size(), 2u);
  EXPECT_EQ(candidates[0].family->name(), "tag36h9");
  EXPECT_EQ(candidates[0].id, 1000u);
  EXPECT_EQ(candidates[1].family->name(), "tag36h9x");
  EXPECT_EQ(candidates[1].id, 1000u);
}

TEST_F(Identify, TellsAMirroredTagOfAnotherFamilyToo) {
  // The mirror image of this tag of aruco-original is a tag of it, too: 0 is a white column at the
  // left of black ones.
  const Identification found = identifier->identify(print_tag(*family("aruco-original"), 0));
  ASSERT_EQ(found.tags.size(), 1u);
  EXPECT_FALSE(found.tags.front().front().mirrored);
  EXPECT_EQ(found.tags.front().front().id, 0u);
  EXPECT_TRUE(std::any_of(found.tags.front().begin(), found.tags.front().end(),
                          [](const Candidate& c) { return c.mirrored; }));
}

TEST_F(Identify, CountsTheCellsThatWereCorrected) {
  const SharedFamily& f = family("tag36h11");
  const Image picture =
      print_word(f->layout(), f->codeword(17) ^ 0b1010001, {.cell_px = 8, .quiet_cells = 1});
  const Identification found = identifier->identify(picture);
  ASSERT_EQ(found.tags.size(), 1u);
  EXPECT_EQ(found.tags.front().front().family, f);
  EXPECT_EQ(found.tags.front().front().id, 17u);
  EXPECT_EQ(found.tags.front().front().hamming, 3);
}

TEST_F(Identify, TellsTheNearestMissBeyondTheSafeRadius) {
  const SharedFamily& f = family("tag36h11");
  Identifier only({f}, 1);
  const codec::Codeword wrong = 0b100010001000100010001;  // 6 bits; 5 are always corrected
  const Identification found = only.identify(
      print_word(f->layout(), f->codeword(3) ^ wrong, {.cell_px = 6, .quiet_cells = 1}));
  EXPECT_TRUE(found.tags.empty());
  ASSERT_TRUE(found.nearest);
  EXPECT_EQ(found.nearest->id, 3u);
  EXPECT_EQ(found.nearest->hamming, 6);
}

TEST_F(Identify, ListsEachTagOfASheetTheLargestFirst) {
  Image sheet(400, 300, 255);
  put(sheet, print_tag(*family("tag25h9"), 4, {.cell_px = 6}), 20, 20);
  put(sheet, mirrored(print_tag(*family("tag36h11"), 5, {.cell_px = 12})), 120, 20);
  put(sheet, print_tag(*family("tagCircle21h7"), 6, {.cell_px = 8}), 300, 200);
  const Identification found = identifier->identify(sheet);
  ASSERT_EQ(found.tags.size(), 3u);
  EXPECT_EQ(found.tags[0].front().family->name(), "tag36h11");
  EXPECT_TRUE(found.tags[0].front().mirrored);
  EXPECT_EQ(found.tags[1].front().family->name(), "tag25h9");
  EXPECT_EQ(found.tags[1].front().id, 4u);
  EXPECT_EQ(found.tags[2].front().family->name(), "tagCircle21h7");
  EXPECT_EQ(found.tags[2].front().id, 6u);
}

TEST_F(Identify, CornersAreThoseOfTheUprightTagInThePicture) {
  const SharedFamily& f = family("tag36h11");
  const Image picture = turned(print_tag(*f, 8, {.cell_px = 10, .quiet_cells = 1}), 1);
  const Candidate found = identifier->identify(picture).tags.at(0).at(0);
  // Turned clockwise, the tag's bottom left corner is at the top left.
  const detect::Corners expected = {{{20, 20}, {20, 100}, {100, 100}, {100, 20}}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(detect::length(found.corners[i] - expected[i]), 0.1) << i;
  }
}

TEST_F(Identify, TellsWhetherAQuietZoneIsInThePicture) {
  const SharedFamily& standard = family("tagStandard41h12");
  EXPECT_FALSE(identifier->identify(print_tag(*standard, 1)).tags.at(0).at(0).quiet_zone);
  EXPECT_TRUE(identifier->identify(print_tag(*standard, 1, {.quiet_cells = 1}))
                  .tags.at(0)
                  .at(0)
                  .quiet_zone);
  // The white ring of classic tags is their quiet zone.
  EXPECT_TRUE(identifier->identify(print_tag(*family("tag36h11"), 1)).tags.at(0).at(0).quiet_zone);
}

TEST_F(Identify, TakesAFamilyOfTheUsersOwn) {
  const SharedFamily own = testing::random_family("own", codec::classic_layout(10), 11, 40);
  std::vector<SharedFamily> with_own = families;
  with_own.push_back(own);
  Identifier wider(with_own, 1);
  const Candidate found =
      wider.identify(print_tag(*own, 39, {.cell_px = 5, .quiet_cells = 1})).tags.at(0).at(0);
  EXPECT_EQ(found.family, own);
  EXPECT_EQ(found.id, 39u);
}

TEST_F(Identify, BelievesNothingOfNoise) {
  testing::FixedRandom random(11);
  for (const int size : {1, 2, 7, 8, 10, 30, 100, 400}) {
    for (int repeat = 0; repeat < 5; ++repeat) {
      Image noise(size, size);
      for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) noise.at(x, y) = static_cast<std::uint8_t>(random.bits());
      }
      EXPECT_TRUE(identifier->identify(noise).tags.empty()) << size;
    }
  }
}

TEST_F(Identify, BelievesNothingOfEvenSurfacesAndFrames) {
  EXPECT_TRUE(identifier->identify(Image(200, 200, 90)).tags.empty());
  EXPECT_TRUE(identifier->identify(Image(8, 8, 0)).tags.empty());
  EXPECT_TRUE(identifier->identify(Image(0, 0)).tags.empty());
  Image frames(300, 300, 255);  // squares in squares
  for (int side = 260, gray = 0; side > 8; side = side * 4 / 5, gray = 255 - gray) {
    put(frames, Image(side, side, static_cast<std::uint8_t>(gray)), (300 - side) / 2,
        (300 - side) / 2);
  }
  const Identification found = identifier->identify(frames);
  EXPECT_TRUE(found.tags.empty());
}

TEST_F(Identify, RefusesASmallFamilyAmongManySquares) {
  // Forty random words in the layout of tag16h5: one in ten is within a bit of one of its tags.
  const SharedFamily& f = family("tag16h5");
  Identifier only({f}, 1);
  testing::FixedRandom random(3);
  Image sheet(520, 330, 255);
  for (int i = 0; i < 40; ++i) {
    const codec::Codeword word = random.bits() & 0xffff;
    put(sheet, print_word(f->layout(), word, {.cell_px = 7}), 4 + i % 8 * 64, 4 + i / 8 * 64);
  }
  const Identification found = only.identify(sheet);
  EXPECT_TRUE(found.tags.empty());
  ASSERT_TRUE(found.nearest);
  EXPECT_GT(found.nearest->expected_accidents, identify::kMostAccidents);
}

TEST_F(Identify, ResultsDoNotDependOnThreads) {
  testing::FixedRandom random(5);
  const Image picture = photograph(*family("tag36h10"), 77, 90, 2.2, random);
  Identifier with_three(families, 3);
  const Candidate one = identifier->identify(picture).tags.at(0).at(0);
  const Candidate three = with_three.identify(picture).tags.at(0).at(0);
  EXPECT_EQ(one.corners, three.corners);
  EXPECT_EQ(one.expected_accidents, three.expected_accidents);
}

TEST(Identifier, RefusesNoFamilyAndAFamilyTwice) {
  const SharedFamily f = codec::find_family("tag16h5");
  EXPECT_THROW(Identifier({nullptr}), std::invalid_argument);
  EXPECT_THROW(Identifier({f, f}), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::test
