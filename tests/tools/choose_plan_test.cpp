#include "cli/choose_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/choose_report.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_stats.h"
#include "tagmint/codec/id_distance.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation_code.h"
#include "tagmint/codec/tag_index.h"

namespace tagmint::cli {
namespace {

using codec::Family;
using codec::FamilyParts;

Candidate bundled(const std::string& name) { return {name, codec::find_family(name)}; }

/// 60 tags at distance 16 inside 2,016 at 12, listed, the last `plain` of each level's own declared
/// plain.
Candidate nested(std::size_t plain = 0) {
  const codec::Layout layout = codec::parse_layout("classic:10");
  const auto code = std::make_shared<const codec::RotationCode>(codec::RotationCodeParts{
      .bits = 36,
      .basis = {0x321ef4119, 0x3de823264, 0xd0464c87b, 0x8c990f7a0, 0xce32cefd, 0xc659dfa19,
                0xb3bf4338c, 0x7e8671967, 0x811c0c1b4, 0xa27c90090, 0x83b61a100, 0x3981c82a,
                0x80ff16a11},
      .levels = {{8, 1}, {13, 1}}});
  const codec::TagIndex index(code, layout, {});
  FamilyParts parts{.name = "nested",
                    .layout = layout,
                    .min_hamming = 12,
                    .codewords = {},
                    .complexity = {},
                    .origin = {},
                    .levels = {{60, 16, plain}, {2016, 12, plain}}};
  for (codec::TagId id = 0; id < 2016; ++id) parts.codewords.push_back(index.codeword(id));
  return {"nested", std::make_shared<const Family>(std::move(parts))};
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
  };
  for (const Case& c : {Case{2, 0, 16}, Case{60, 0, 16}, Case{61, 1, 12}, Case{2016, 1, 12}}) {
    const FamilyChoice choice = only_choice(nested(), use_of(c.tags));
    EXPECT_EQ(choice.level, c.level) << c.tags;
    EXPECT_EQ(choice.ids, (std::vector<IdRange>{{0, static_cast<codec::TagId>(c.tags - 1)}}));
    EXPECT_GE(choice.min_hamming, c.min_hamming) << c.tags;
    EXPECT_EQ(choice.safe_errors, (choice.min_hamming - 1) / 2) << c.tags;
  }
  EXPECT_EQ(only_choice(nested(), use_of(60)).min_hamming, 16);
  EXPECT_EQ(only_choice(nested(), use_of(2016)).min_hamming, 12);
}

TEST(ChoosePlan, TheDistanceIsThatOfTheIdsInUse) {
  const FamilyChoice few = only_choice(bundled("tag36h11"), use_of(2));
  EXPECT_EQ(few.min_hamming, codec::distance_of_ids(*few.family, std::vector<codec::TagId>{0, 1}));
  EXPECT_GT(few.min_hamming, 11);
}

TEST(ChoosePlan, TakesTagsThatPassTheComplexityRuleFirst) {
  using Ranges = std::vector<IdRange>;
  // Of each level's own ids the last five are plain: 55-59 and 2011-2015.
  EXPECT_EQ(only_choice(nested(5), use_of(55)).ids, (Ranges{{0, 54}}));
  EXPECT_EQ(only_choice(nested(5), use_of(55)).plain_ids, 0U);
  const FamilyChoice all = only_choice(nested(5), use_of(58));
  EXPECT_EQ(all.ids, (Ranges{{0, 57}}));
  EXPECT_EQ(all.plain_ids, 3U);
  EXPECT_TRUE(has(all, Caution::PlainTags));
  const FamilyChoice second = only_choice(nested(5), use_of(100));
  EXPECT_EQ(second.ids, (Ranges{{0, 54}, {60, 104}}));
  EXPECT_EQ(second.plain_ids, 0U);
  EXPECT_FALSE(has(second, Caution::PlainTags));
  const FamilyChoice most = only_choice(nested(5), use_of(2008));
  EXPECT_EQ(most.ids, (Ranges{{0, 56}, {60, 2010}}));
  EXPECT_EQ(most.plain_ids, 2U);
  EXPECT_EQ(only_choice(nested(5), use_of(2016)).ids, (Ranges{{0, 2015}}));
}

TEST(ChoosePlan, FalseAcceptsAreThoseOfTheIdsInUse) {
  const FamilyChoice choice = only_choice(nested(), use_of(50));
  EXPECT_DOUBLE_EQ(choice.accepted_at_2, 4.0 * 50 * (1 + 36 + 630) / 68719476736.0);
  EXPECT_DOUBLE_EQ(choice.accepted_at_safe, codec::false_accept_rate(50, 36, choice.safe_errors));
  EXPECT_DOUBLE_EQ(choice.accepted, codec::false_accept_rate(50, 36, choice.max_hamming));
}

TEST(ChoosePlan, CorrectsAsMuchAsIsSafeAndAcceptable) {
  for (const std::size_t tags : {1, 9, 60, 200, 2016}) {
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
      choose_families(std::vector{bundled("tag16h5"), bundled("tag36h11"), nested()}, use_of(588));
  EXPECT_EQ(names_of(plan), std::vector<std::string>{"nested"});
  ASSERT_EQ(plan.too_small.size(), 2U);
  EXPECT_EQ(plan.too_small[0].name, "tag16h5");
  EXPECT_EQ(plan.too_small[0].tags, 30U);
  EXPECT_EQ(plan.too_small[1].tags, 587U);
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
