#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/s8_reconcile.h"
#include "support/fixed_random.h"
#include "support/paint_tags.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::detect {
namespace {

codec::SharedFamily family(const std::string& name) {
  return testing::random_family(name, codec::classic_layout(8), 5, 6);
}

const codec::SharedFamily kAlpha = family("alpha");
const codec::SharedFamily kBeta = family("beta");

Detection at(Point centre, codec::TagId id, double side = 20, int hamming = 0, double margin = 50,
             const codec::SharedFamily& of = kAlpha) {
  const Homography h = testing::square_at(centre, side);
  Detection detection;
  detection.family = of;
  detection.id = id;
  detection.hamming = hamming;
  detection.decision_margin = margin;
  detection.center = centre;
  detection.corners = testing::corners_of(h);
  detection.homography = h;
  return detection;
}

std::vector<Detection> reconciled(std::vector<Detection> candidates) {
  DetectStats stats;
  const std::size_t given = candidates.size();
  std::vector<Detection> kept = std::move(candidates);
  reconcile(kept, stats);
  EXPECT_EQ(stats.detections, static_cast<std::int64_t>(kept.size()));
  EXPECT_EQ(stats.duplicates, static_cast<std::int64_t>(given - kept.size()));
  return kept;
}

TEST(Reconcile, FewerErrorsWinThenTheLargerMargin) {
  const auto by_hamming = reconciled({at({50, 50}, 1, 20, 2, 90), at({51, 50}, 1, 20, 0, 10)});
  ASSERT_EQ(by_hamming.size(), 1u);
  EXPECT_EQ(by_hamming[0].hamming, 0);
  const auto by_margin = reconciled({at({50, 50}, 1, 20, 1, 10), at({51, 50}, 1, 20, 1, 90)});
  ASSERT_EQ(by_margin.size(), 1u);
  EXPECT_EQ(by_margin[0].decision_margin, 90);
}

TEST(Reconcile, TheSameTagInTwoPlacesStaysTwice) {
  EXPECT_EQ(reconciled({at({50, 50}, 1), at({90, 50}, 1)}).size(), 2u);
  EXPECT_EQ(reconciled({at({50, 50}, 1), at({70, 50}, 1)}).size(), 2u);  // they touch
}

TEST(Reconcile, OtherIdsAndFamiliesMayOverlapOrNest) {
  EXPECT_EQ(reconciled({at({50, 50}, 1, 40), at({50, 50}, 2, 8)}).size(), 2u);
  EXPECT_EQ(
      reconciled({at({50, 50}, 1, 40), at({50, 50}, 1, 8, 0, 50, kBeta), at({52, 50}, 3)}).size(),
      3u);
}

Detection turned(Detection d, int turns) {
  std::rotate(d.corners.begin(), d.corners.begin() + turns, d.corners.end());
  return d;
}

TEST(Reconcile, OneQuadIsOneTagOfTheFamilyThatChanceHitsLeast) {
  const codec::SharedFamily small = kAlpha;  // six tags of 16 bits
  const codec::SharedFamily large =
      testing::random_family("large", codec::classic_layout(10), 9, 6);
  const auto place_of = [&](const codec::SharedFamily& of, int hamming, double margin) {
    return at({50, 50}, 1, 40, hamming, margin, of);
  };
  // Two errors in 36 bits tell more than none in 16, whatever the margins and the turn.
  for (const auto& candidates :
       {std::vector{place_of(small, 0, 90), turned(place_of(large, 2, 20), 3)},
        std::vector{turned(place_of(large, 2, 20), 1), place_of(small, 0, 90)}}) {
    const auto kept = reconciled(candidates);
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept[0].family, large);
  }
  // Families of one size: fewer errors, then the larger margin.
  EXPECT_EQ(reconciled({place_of(kAlpha, 1, 90), place_of(kBeta, 0, 20)})[0].family, kBeta);
  EXPECT_EQ(reconciled({place_of(kAlpha, 1, 90), place_of(kBeta, 1, 20)})[0].family, kAlpha);
}

TEST(Reconcile, SortedByFamilyIdThenPlaceWhateverTheOrderBefore) {
  std::vector<Detection> candidates = {at({10, 90}, 1),
                                       at({50, 50}, 1),
                                       at({90, 50}, 1),
                                       at({90, 90}, 0),
                                       at({10, 10}, 3),
                                       at({52, 51}, 1, 20, 1),
                                       at({12, 90}, 1, 20, 0, 50),
                                       at({10, 50}, 0, 20, 0, 50, kBeta)};
  const std::vector<Detection> expected = reconciled(candidates);
  ASSERT_EQ(expected.size(), 6u);
  EXPECT_EQ(expected[0].id, 0u);
  EXPECT_EQ(expected[1].center, (Point{50, 50}));
  EXPECT_EQ(expected[2].center, (Point{90, 50}));
  EXPECT_EQ(expected[3].center, (Point{10, 90}));
  EXPECT_EQ(expected[4].id, 3u);
  EXPECT_EQ(expected[5].family->name(), "beta");
  testing::FixedRandom random(3);
  for (int trial = 0; trial < 50; ++trial) {
    for (std::size_t i = candidates.size(); i > 1; --i) {
      std::swap(candidates[i - 1], candidates[random.between(0, static_cast<int>(i) - 1)]);
    }
    const std::vector<Detection> again = reconciled(candidates);
    ASSERT_EQ(again.size(), expected.size());
    for (std::size_t i = 0; i < again.size(); ++i) {
      EXPECT_EQ(again[i].center, expected[i].center);
      EXPECT_EQ(again[i].id, expected[i].id);
    }
  }
}

TEST(Reconcile, NothingStaysNothing) { EXPECT_TRUE(reconciled({}).empty()); }

}  // namespace
}  // namespace tagmint::detect
