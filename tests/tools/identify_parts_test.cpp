// The parts that identification is made of.
#include <gtest/gtest.h>

#include <algorithm>

#include "identify/cell_grid.h"
#include "identify/evidence.h"
#include "identify/nearest_tags.h"
#include "identify/places.h"
#include "identify/reading.h"
#include "identify/reduce.h"
#include "support/tag_pictures.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_stats.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::test {
namespace {

using codec::SharedFamily;
using detect::Corners;
using detect::Homography;
using detect::Image;
using identify::BorderPart;
using identify::CellGrid;
using identify::Doubt;
using identify::Evidence;
using identify::Frame;
using identify::Place;
using identify::Reading;

Homography square(double left, double top, double side) {
  const Corners corners = {
      {{left, top + side}, {left + side, top + side}, {left + side, top}, {left, top}}};
  return *Homography::from_corners(corners);
}

TEST(CellGrid, HoldsTheCellsOfAPrintAndNothingOutsideOfThePicture) {
  const SharedFamily f = codec::find_family("tag36h11");
  const Image picture = print_tag(*f, 5, {.cell_px = 4, .quiet_cells = -1});
  const Frame frame = identify::frame_of(f->layout());
  const CellGrid grid = identify::read_cells(picture, square(0, 0, 32), frame);
  EXPECT_FALSE(grid.at(0, 5));
  EXPECT_FALSE(grid.at(9, 9));
  const Image cells = print_tag(*f, 5);
  for (int y = 1; y < 9; ++y) {
    for (int x = 1; x < 9; ++x) EXPECT_EQ(grid.at(x, y), double(cells.at(x, y))) << x << ' ' << y;
  }
  EXPECT_EQ(grid.mirrored().at(2, 3), grid.at(7, 3));
}

TEST(ReadTag, ReadsTheWordItsColoursAndTheBorder) {
  const SharedFamily f = codec::find_family("tagStandard41h12");
  const Image picture = print_tag(*f, 9, {.cell_px = 3, .black = 60, .white = 90});
  const CellGrid grid =
      identify::read_cells(picture, square(6, 6, 15), identify::frame_of(f->layout()));
  const std::vector<Reading> readings = identify::read_tag(grid, f->layout());
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].word, f->codeword(9));
  EXPECT_FALSE(readings[0].inverted);
  EXPECT_EQ(readings[0].border, BorderPart::Whole);
  EXPECT_TRUE(readings[0].clear);
}

TEST(ReadTag, FollowsLightThatFallsOffAcrossTheTag) {
  const SharedFamily f = codec::find_family("tag36h11");
  Image picture = print_tag(*f, 9, {.cell_px = 6, .black = 40, .white = 220});
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      // From full light to a fifth: white at the right is darker than half of white at the left.
      picture.at(x, y) =
          static_cast<std::uint8_t>(picture.at(x, y) * (1 - 0.8 * x / picture.width()));
    }
  }
  const CellGrid grid =
      identify::read_cells(picture, square(6, 6, 48), identify::frame_of(f->layout()));
  const std::vector<Reading> readings = identify::read_tag(grid, f->layout());
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].word, f->codeword(9));
}

TEST(ReadTag, ReadsBothColoursWhereTheBorderIsMissing) {
  const SharedFamily f = codec::find_family("tag36h11");
  const Image picture = print_tag(*f, 9, {.cell_px = 4, .quiet_cells = -2});
  const CellGrid grid =
      identify::read_cells(picture, square(-4, -4, 32), identify::frame_of(f->layout()));
  const std::vector<Reading> readings = identify::read_tag(grid, f->layout());
  ASSERT_EQ(readings.size(), 2u);
  EXPECT_EQ(readings[0].word, f->codeword(9));
  EXPECT_EQ(readings[1].word, ~f->codeword(9) & codec::low_mask(36));
  EXPECT_TRUE(readings[1].inverted);
  EXPECT_EQ(readings[1].border, BorderPart::None);
}

TEST(ReadTag, RefusesARingThatIsNotEvenOrMissingData) {
  const SharedFamily f = codec::find_family("tag36h11");
  Image picture = print_tag(*f, 9, {.cell_px = 4});
  const Frame frame = identify::frame_of(f->layout());
  const CellGrid shifted = identify::read_cells(picture, square(10, 10, 32), frame);
  EXPECT_TRUE(identify::read_tag(shifted, f->layout()).empty());
  const CellGrid outside = identify::read_cells(picture, square(-20, 4, 32), frame);
  EXPECT_TRUE(identify::read_tag(outside, f->layout()).empty());
  put(picture, Image(40, 20, 255), 0, 0);  // half of it painted over
  const CellGrid painted = identify::read_cells(picture, square(4, 4, 32), frame);
  EXPECT_TRUE(identify::read_tag(painted, f->layout()).empty());
}

TEST(NearestTags, ComparesAndLooksUpAlike) {
  identify::NearestTags nearest;
  for (const char* name : {"tag16h5", "tag36h10", "rot41"}) {  // compared, chunks, information sets
    const SharedFamily f = codec::find_family(name);
    const auto id = static_cast<codec::TagId>(f->size() / 2);
    const codec::Codeword seen = codec::rotate(f->codeword(id), f->bits(), 3) ^ 0b11;
    const std::vector<codec::Match> found = nearest.find(f, seen);
    ASSERT_EQ(found.size(), 1u) << name;
    EXPECT_EQ(found[0], (codec::Match{id, 2, 1})) << name;
  }
}

TEST(NearestTags, TellsAllThatAreEquallyNear) {
  const SharedFamily f = codec::find_family("tag16h5");
  identify::NearestTags nearest;
  bool tie_seen = false;
  for (codec::Codeword word = 0; word < 4096; word += 7) {
    const std::vector<codec::Match> found = nearest.find(f, word);
    ASSERT_FALSE(found.empty());
    for (codec::TagId id = 0; id < f->size(); ++id) {
      const int distance = codec::rotation_distance(f->codeword(id), word, f->bits());
      ASSERT_GE(distance, found[0].hamming);
      const bool listed = std::any_of(found.begin(), found.end(),
                                      [&](const codec::Match& m) { return m.id == id; });
      EXPECT_EQ(listed, distance == found[0].hamming);
    }
    tie_seen |= found.size() > 1;
  }
  EXPECT_TRUE(tie_seen);
}

TEST(Evidence, ExpectsOneAccidentInAsManyWordsAsTheRateSays) {
  const SharedFamily f = codec::find_family("tag16h5");
  Evidence evidence;
  const double rate = Evidence::accept_rate(*f, 1);
  EXPECT_EQ(evidence.expected_accidents(rate, {}), 0);
  for (int i = 0; i < 10; ++i) evidence.count(*f, {});
  EXPECT_DOUBLE_EQ(evidence.expected_accidents(rate, {}), 10 * rate);
  // No error would have to be as unlikely as that.
  EXPECT_EQ(evidence.expected_accidents(1e-9, {}), 0);
}

TEST(Evidence, OfEachFamilyCountsWhatIsAsConvincing) {
  const SharedFamily small = codec::find_family("tag16h5");
  const SharedFamily large = codec::find_family("tag36h11");
  Evidence evidence;
  evidence.count(*small, {});
  evidence.count(*large, {});
  const double rate = Evidence::accept_rate(*small, 0);
  double of_large = 0;
  for (int errors = 0; codec::false_accept_rate(large->size(), 36, errors) <= rate; ++errors) {
    of_large = codec::false_accept_rate(large->size(), 36, errors);
  }
  EXPECT_DOUBLE_EQ(evidence.expected_accidents(rate, {}), rate + of_large);
}

TEST(Evidence, AccountsOfMoreDoubtDoNotCountAgainstLess) {
  const SharedFamily f = codec::find_family("tag16h5");
  const double rate = Evidence::accept_rate(*f, 0);
  Evidence evidence;
  evidence.count(*f, {.unclear = true, .oddity = 0});
  evidence.count(*f, {.unclear = false, .oddity = 2});
  EXPECT_EQ(evidence.expected_accidents(rate, {}), 0);
  EXPECT_DOUBLE_EQ(evidence.expected_accidents(rate, {.unclear = true, .oddity = 1}), rate);
  EXPECT_DOUBLE_EQ(evidence.expected_accidents(rate, {.unclear = true, .oddity = 4}), 2 * rate);
}

TEST(IsPlain, EvenAndHalvedSurfacesArePlainBundledTagsAreNot) {
  const codec::Layout layout = codec::classic_layout(10);
  EXPECT_TRUE(identify::is_plain(layout, 0));
  EXPECT_TRUE(identify::is_plain(layout, codec::low_mask(36)));
  EXPECT_TRUE(identify::is_plain(layout, 1));
  for (const std::string& name : codec::family_names()) {
    const SharedFamily f = codec::find_family(name);
    const std::size_t step = std::max<std::size_t>(1, f->size() / 2000);
    for (std::size_t id = 0; id < f->size(); id += step) {
      ASSERT_FALSE(identify::is_plain(f->layout(), f->codeword(static_cast<codec::TagId>(id))))
          << name << ' ' << id;
    }
  }
}

TEST(IsDeclaredPlain, AreTheLastTagsThatALevelAdds) {
  const SharedFamily f = codec::find_family("rot36");
  const auto levels = f->levels();
  ASSERT_GT(levels.back().plain, 0u);
  const std::size_t first_plain = levels.back().codes - levels.back().plain;
  const auto plain = [&](std::size_t id) {
    return identify::is_declared_plain(*f, static_cast<codec::TagId>(id));
  };
  EXPECT_FALSE(plain(first_plain - 1));
  EXPECT_TRUE(plain(first_plain));
  EXPECT_TRUE(plain(f->size() - 1));
  EXPECT_FALSE(identify::is_declared_plain(*codec::find_family("tag36h11"), 586));
}

TEST(FindCellGrids, FindsEachTagOfAMosaicAtItsPixel) {
  const SharedFamily f = codec::find_family("tag36h11");
  Image mosaic(23, 12, 255);
  put(mosaic, print_tag(*f, 0), 1, 1);
  put(mosaic, inverted(print_tag(*f, 1)), 12, 1);
  const std::vector<Place> places =
      identify::find_cell_grids(mosaic, {identify::frame_of(f->layout())});
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].corners[3], (detect::Point{2, 2}));
  EXPECT_EQ(places[0].corners[1], (detect::Point{10, 10}));
  EXPECT_EQ(places[1].corners[3], (detect::Point{13, 2}));
  EXPECT_EQ(places[0].cells_at_border, 8);
}

TEST(FindCellGrids, LeavesPicturesOfManyGrayLevelsAlone) {
  const SharedFamily f = codec::find_family("tag36h11");
  Image picture(40, 40, 255);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) picture.at(x, y) = static_cast<std::uint8_t>(6 * x);
  }
  put(picture, print_tag(*f, 0), 15, 15);
  EXPECT_TRUE(identify::find_cell_grids(picture, {identify::frame_of(f->layout())}).empty());
}

TEST(FilledPlaces, HaveTheBorderSquareOfEachCut) {
  const Frame frame{10, 1};
  const std::vector<Place> places = identify::filled_places(Image(80, 80, 5), {{frame, 2}});
  ASSERT_EQ(places.size(), 3u);
  EXPECT_EQ(places[0].corners[3], (detect::Point{8, 8}));  // the whole tag is seen
  EXPECT_EQ(places[1].corners[3], (detect::Point{0, 0}));  // without its white ring
  EXPECT_EQ(places[2].corners[3].x, -80.0 / 6);            // its data cells alone
  EXPECT_TRUE(identify::filled_places(Image(80, 90, 5), {{frame, 2}}).empty());
}

TEST(SquareFinder, FindsSquaresInsideAndAtTheEdge) {
  identify::SquareFinder finder(1);
  Image picture(100, 100, 200);
  put(picture, Image(40, 40, 20), 30, 30);
  const auto covers = [](const std::vector<Place>& places, double left, double side) {
    return std::any_of(places.begin(), places.end(), [&](const Place& place) {
      const auto& c = place.corners;
      const detect::Point middle = 0.25 * (c[0] + c[1] + c[2] + c[3]);
      return std::abs(middle.x - left - side / 2) < 0.5 &&
             std::abs(std::abs(detect::signed_area(c)) - side * side) < side;
    });
  };
  EXPECT_TRUE(covers(finder.find(picture), 30, 40));
  const Image black(60, 60, 20);
  EXPECT_FALSE(covers(finder.find(black), 0, 60));
  EXPECT_TRUE(covers(finder.find_at_edges(black), 0, 60));
}

TEST(Reduce, HalvesByMeansAndAddsMargins) {
  Image picture(5, 2, 10);
  picture.at(2, 0) = 50;
  const Image half = identify::half_size(picture);
  EXPECT_EQ(half.width(), 2);
  EXPECT_EQ(half.height(), 1);
  EXPECT_EQ(half.at(1, 0), 20);
  const Image larger = identify::with_margin(picture, 3, 77);
  EXPECT_EQ(larger.width(), 11);
  EXPECT_EQ(larger.at(2, 4), 77);
  EXPECT_EQ(larger.at(5, 3), 50);
}

}  // namespace
}  // namespace tagmint::test
