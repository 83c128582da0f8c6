#include "cli/choose_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/choose_report.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_stats.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::cli {
namespace {

using codec::Family;
using codec::FamilyParts;

Candidate bundled(const std::string& name) { return {name, codec::find_family(name)}; }

/// `codes` arbitrary words with those levels: for what is planned, not for how far apart they are.
Candidate family_of(const std::string& name, const std::string& layout, std::size_t codes,
                    std::vector<codec::Level> levels) {
  FamilyParts parts{.name = name,
                    .layout = codec::parse_layout(layout),
                    .min_hamming = levels.back().min_hamming,
                    .codewords = {},
                    .complexity = {},
                    .origin = {},
                    .levels = std::move(levels)};
  for (std::size_t i = 0; i < codes; ++i) parts.codewords.push_back(0x1234567 + 31 * i);
  return {name, std::make_shared<const Family>(std::move(parts))};
}

/// A family of 36 bits as rotation codes make them.
Candidate nested() {
  return family_of("nested", "classic:10", 300, {{60, 16}, {200, 12}, {300, 8}});
}

TagUse use_of(std::size_t tags, double distance_mm = 1000) {
  return {.tags = tags, .size_mm = 40, .outer = false, .focal_px = 600, .distance_mm = distance_mm};
}

std::vector<std::string> names_of(const ChoosePlan& plan) {
  std::vector<std::string> names;
  for (const FamilyChoice& choice : plan.ranked) names.push_back(choice.family->name());
  return names;
}

FamilyChoice only_choice(const Candidate& candidate, const TagUse& use) {
  const ChoosePlan plan = choose_families(std::vector{candidate}, use);
  EXPECT_EQ(plan.ranked.size(), 1U);
  return plan.ranked.at(0);
}

bool has(const FamilyChoice& choice, Caution caution) {
  return std::count(choice.cautions.begin(), choice.cautions.end(), caution) == 1;
}

TEST(ChoosePlan, CountsPixelsACell) {
  // 40 mm over 8 cells are 5 mm; 600 px at 1 m are 0.6 px a mm.
  const FamilyChoice choice = only_choice(bundled("tag36h11"), use_of(30));
  EXPECT_DOUBLE_EQ(choice.cell_px, 3);
  EXPECT_DOUBLE_EQ(choice.edge_mm, 40);
  EXPECT_DOUBLE_EQ(choice.outer_mm, 50);
  EXPECT_DOUBLE_EQ(choice.with_quiet_zone_mm, 50);  // its white ring is part of the tag
  // 5 cells at the border, 9 in all, and one of white on each side.
  const FamilyChoice standard = only_choice(bundled("tagStandard41h12"), use_of(30));
  EXPECT_DOUBLE_EQ(standard.cell_px, 4.8);
  EXPECT_DOUBLE_EQ(standard.outer_mm, 72);
  EXPECT_DOUBLE_EQ(standard.with_quiet_zone_mm, 88);
}

TEST(ChoosePlan, TakesTheSideOfTheWholeTagToo) {
  TagUse use = use_of(30);
  use.outer = true;
  use.size_mm = 50;
  EXPECT_DOUBLE_EQ(only_choice(bundled("tag36h11"), use).edge_mm, 40);
  EXPECT_DOUBLE_EQ(only_choice(bundled("tagCircle49h12"), use).edge_mm, 50 * 5.0 / 11);
}

TEST(ChoosePlan, TakesTheSmallestLevelThatHoldsTheTags) {
  struct Case {
    std::size_t tags;
    std::size_t level;
    int min_hamming;
    int safe_errors;
  };
  for (const Case& c : {Case{1, 0, 16, 7}, Case{60, 0, 16, 7}, Case{61, 1, 12, 5},
                        Case{200, 1, 12, 5}, Case{201, 2, 8, 3}}) {
    const FamilyChoice choice = only_choice(nested(), use_of(c.tags));
    EXPECT_EQ(choice.level, c.level) << c.tags;
    EXPECT_EQ(choice.min_hamming, c.min_hamming) << c.tags;
    EXPECT_EQ(choice.safe_errors, c.safe_errors) << c.tags;
    EXPECT_EQ(choice.ids, (std::vector<IdRange>{{0, static_cast<codec::TagId>(c.tags - 1)}}));
  }
}

TEST(ChoosePlan, FalseAcceptsAreThoseOfTheIdsInUse) {
  const FamilyChoice choice = only_choice(nested(), use_of(50));
  EXPECT_DOUBLE_EQ(choice.accepted_at_2, 4.0 * 50 * (1 + 36 + 630) / 68719476736.0);
  EXPECT_DOUBLE_EQ(choice.accepted_at_safe, codec::false_accept_rate(50, 36, 7));
  EXPECT_DOUBLE_EQ(choice.accepted, codec::false_accept_rate(50, 36, choice.max_hamming));
}

TEST(ChoosePlan, CorrectsAsMuchAsIsSafeAndAcceptable) {
  for (const std::size_t tags : {1, 9, 60, 200, 300}) {
    const FamilyChoice choice = only_choice(nested(), use_of(tags));
    EXPECT_LE(choice.max_hamming, choice.safe_errors);
    EXPECT_LE(choice.accepted, kAcceptedRate);
    if (choice.max_hamming < choice.safe_errors) {
      EXPECT_GT(codec::false_accept_rate(tags, 36, choice.max_hamming + 1), kAcceptedRate);
    }
  }
  // All of tag36h11 with two errors is what is acceptable.
  EXPECT_EQ(only_choice(bundled("tag36h11"), use_of(587)).max_hamming, 2);
  const FamilyChoice small = only_choice(bundled("tag16h5"), use_of(30));
  EXPECT_EQ(small.max_hamming, 0);
  EXPECT_TRUE(has(small, Caution::ManyFalseAccepts));
}

TEST(ChoosePlan, TheRangeIsWhereTheTagsAreStillRead) {
  for (const char* name : {"tag36h11", "tagStandard41h12", "tagCircle49h12"}) {
    const double range_mm = only_choice(bundled(name), use_of(30)).range_mm;
    EXPECT_NEAR(only_choice(bundled(name), use_of(30, range_mm)).found, kReliableShare, 0.01);
    EXPECT_EQ(only_choice(bundled(name), use_of(30, range_mm * 1.001)).readability,
              Readability::Beyond);
    EXPECT_EQ(only_choice(bundled(name), use_of(30, range_mm * 0.999)).readability,
              Readability::Just);
    EXPECT_EQ(only_choice(bundled(name), use_of(30, range_mm / 1.501)).readability,
              Readability::Well);
  }
}

TEST(ChoosePlan, LeavesOutFamiliesWithTooFewTags) {
  const ChoosePlan plan =
      choose_families(std::vector{bundled("tag16h5"), bundled("tag36h11"), nested()}, use_of(301));
  EXPECT_EQ(names_of(plan), std::vector<std::string>{"tag36h11"});
  ASSERT_EQ(plan.too_small.size(), 2U);
  EXPECT_EQ(plan.too_small[0].name, "tag16h5");
  EXPECT_EQ(plan.too_small[0].tags, 30U);
  EXPECT_EQ(plan.too_small[1].tags, 300U);
}

TEST(ChoosePlan, RanksWhatCanBeReadThereFirst) {
  const std::vector<Candidate> candidates = {bundled("tag36h11"), bundled("tagStandard52h13"),
                                             bundled("tagStandard41h12"), bundled("tag16h5")};
  // Near by, the share of cells that may be wrong decides: 6 of 52, 4 of 41, 3 of 36; tag16h5 takes
  // too many random words.
  EXPECT_EQ(
      names_of(choose_families(candidates, use_of(30, 1000))),
      (std::vector<std::string>{"tagStandard52h13", "tagStandard41h12", "tag36h11", "tag16h5"}));
  // At 3.2 m cells are 1.5 px for 5 at the border, 1.25 px for 6, 0.94 px for 8.
  const ChoosePlan far = choose_families(candidates, use_of(30, 3200));
  EXPECT_EQ(names_of(far).front(), "tagStandard41h12");
  EXPECT_EQ(names_of(far).back(), "tag36h11");
}

TEST(ChoosePlan, OutOfRangeTheLongestRangeIsFirst) {
  const ChoosePlan plan = choose_families(
      std::vector{bundled("tag36h11"), bundled("tag25h9"), bundled("tagStandard41h12")},
      use_of(30, 20000));
  EXPECT_EQ(names_of(plan), (std::vector<std::string>{"tagStandard41h12", "tag25h9", "tag36h11"}));
  for (const FamilyChoice& choice : plan.ranked) EXPECT_TRUE(has(choice, Caution::BeyondRange));
}

TEST(ChoosePlan, ALargerDistanceWinsAmongFamiliesThatCorrectAsMuch) {
  const ChoosePlan plan = choose_families(std::vector{bundled("tag36h11"), nested()}, use_of(60));
  EXPECT_EQ(plan.ranked[0].max_hamming, plan.ranked[1].max_hamming);
  EXPECT_EQ(plan.ranked[0].family->name(), "nested");
}

TEST(ChoosePlan, TellsWhoElseReadsTheTags) {
  using Programs = std::vector<std::string>;
  EXPECT_EQ(only_choice(bundled("tag36h11"), use_of(5)).read_by,
            (Programs{"libapriltag", "OpenCV"}));
  EXPECT_EQ(only_choice(bundled("tagStandard52h13"), use_of(5)).read_by, Programs{"libapriltag"});
  EXPECT_TRUE(only_choice(nested(), use_of(5)).read_by.empty());
  // The completed families begin with the published tags.
  const FamilyChoice within = only_choice(bundled("tagStandard41h12x"), use_of(2115));
  EXPECT_EQ(within.read_by, Programs{"libapriltag"});
  EXPECT_EQ(within.known_as, "tagStandard41h12");
  const FamilyChoice beyond = only_choice(bundled("tagStandard41h12x"), use_of(2116));
  EXPECT_TRUE(beyond.read_by.empty());
  EXPECT_EQ(beyond.known_as, "");
}

TEST(ChoosePlan, WarnsOfHolesCustomLayoutsAndLargeIds) {
  const FamilyChoice custom = only_choice(bundled("tagCustom48h12x"), use_of(65536));
  EXPECT_TRUE(has(custom, Caution::Hole));
  EXPECT_TRUE(has(custom, Caution::CustomLayout));
  EXPECT_TRUE(has(custom, Caution::LargeIds));
  EXPECT_FALSE(has(only_choice(bundled("tagCustom48h12x"), use_of(65535)), Caution::LargeIds));
  EXPECT_TRUE(only_choice(bundled("tag36h11"), use_of(9)).cautions.empty());
}

TEST(ChoosePlan, WritesIdsAsTheOptionTakesThem) {
  EXPECT_EQ(id_list_text(std::vector<IdRange>{{0, 0}}), "0");
  EXPECT_EQ(id_list_text(std::vector<IdRange>{{0, 56}, {60, 85}, {99, 99}}), "0-56,60-85,99");
}

TEST(ChoosePlan, RatesAreWrittenForPeople) {
  EXPECT_EQ(one_in_text(1.0 / 546), "1 in 546");
  EXPECT_EQ(one_in_text(2.2848e-5), "1 in 43,800");
  EXPECT_EQ(one_in_text(3e-9), "1 in 333,000,000");
  EXPECT_EQ(one_in_text(1e-12), "1 in 1.0e+12");
  EXPECT_EQ(one_in_text(1), "1 in 1");
}

}  // namespace
}  // namespace tagmint::cli
