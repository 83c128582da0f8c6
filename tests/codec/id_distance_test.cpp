#include "tagmint/codec/id_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

/// From nothing but rotation.h.
int distance_by_definition(const Family& family, const std::vector<TagId>& ids) {
  int least = family.bits();
  for (const TagId a : ids) {
    least = std::min(least, self_distance(family.codeword(a), family.bits()));
    for (const TagId b : ids) {
      if (a == b) continue;
      least =
          std::min(least, rotation_distance(family.codeword(a), family.codeword(b), family.bits()));
    }
  }
  return least;
}

std::vector<TagId> ids_from(TagId first, std::size_t count) {
  std::vector<TagId> ids(count);
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

TEST(IdDistance, OfAFewTagsIsWhatTheirCodewordsSay) {
  for (const char* name : {"tag16h5", "tag25h9", "tag36h11", "tagCircle21h7", "tagCustom48h12"}) {
    const SharedFamily family = find_family(name);
    const std::vector<std::vector<TagId>> lists = {{3}, {0, 1}, {7, 11, 13, 29}, ids_from(2, 20)};
    for (const std::vector<TagId>& ids : lists) {
      EXPECT_EQ(distance_of_ids(*family, ids), distance_by_definition(*family, ids)) << name;
      EXPECT_GE(distance_of_ids(*family, ids), family->min_hamming());
    }
  }
}

TEST(IdDistance, ASubListCanBeFartherApartThanTheFamily) {
  // Every tag that keeps 13 bits from those taken before it and from its own turns.
  const SharedFamily family = find_family("tag36h11");
  std::vector<TagId> far;
  for (TagId id = 0; id < family->size(); ++id) {
    far.push_back(id);
    if (distance_by_definition(*family, far) < 13) far.pop_back();
  }
  ASSERT_GT(far.size(), 5U);
  EXPECT_EQ(distance_of_ids(*family, {}), 11);
  EXPECT_GE(distance_of_ids(*family, far), 13);
  EXPECT_EQ(distance_of_ids(*family, far), distance_by_definition(*family, far));
}

TEST(IdDistance, ASingleTagIsComparedWithItsOwnTurns) {
  const SharedFamily family = find_family("tag36h11");
  const TagId id = 5;
  EXPECT_EQ(distance_of_ids(*family, std::vector<TagId>{id}),
            self_distance(family->codeword(id), 36));
}

TEST(IdDistance, OrderAndRepetitionsDoNotMatter) {
  const std::vector<TagId> once = {9, 40, 586};
  EXPECT_EQ(ascending_ids({586, 9, 9, 40, 586}), once);
  EXPECT_EQ(ascending_ids(once), once);
  EXPECT_TRUE(ascending_ids({}).empty());
  const SharedFamily family = find_family("tag36h11");
  EXPECT_EQ(distance_of_ids(*family, std::vector<TagId>{586, 9, 9, 40, 586}),
            distance_of_ids(*family, once));
}

/// Sixteen words of 16 bits that are nothing special, with distances as they are declared here.
Family declared_family() {
  FamilyParts parts{"declared", classic_layout(8), 2, {}, {}, {}, {{4, 9}, {10, 5}, {16, 2}}};
  for (Codeword i = 0; i < 16; ++i) parts.codewords.push_back(0x2c71 ^ i * 0x1357 % 0x10000);
  return Family(std::move(parts));
}

TEST(IdDistance, AWholeLevelIsWhatIsDeclared) {
  const Family family = declared_family();
  EXPECT_EQ(distance_of_ids(family, {}), 2);
  EXPECT_EQ(distance_of_ids(family, ids_from(0, 16)), 2);
  EXPECT_EQ(distance_of_ids(family, ids_from(0, 10)), 5);
  EXPECT_EQ(distance_of_ids(family, ids_from(0, 4)), 9);
  const std::vector<TagId> most = ids_from(0, 9);
  EXPECT_EQ(distance_of_ids(family, most), distance_by_definition(family, most));
}

TEST(IdDistance, LongListsHaveTheDistanceDeclaredForTheSmallestLevelThatHoldsThem) {
  const SharedFamily family = find_family("tagCustom48h12");
  FamilyParts parts{"levels", family->layout(), 12, {}, {}, {}, {{20000, 13}, {42211, 12}}};
  parts.codewords.assign(family->codewords().begin(), family->codewords().end());
  const Family levels(std::move(parts));
  EXPECT_EQ(distance_of_ids(levels, ids_from(1, kMostComparedIds + 1)), 13);
  EXPECT_EQ(distance_of_ids(levels, ids_from(12000, kMostComparedIds + 1)), 12);
  const std::vector<TagId> compared = ids_from(1, 500);
  EXPECT_EQ(distance_of_ids(levels, compared), distance_by_definition(*family, compared));
}

TEST(IdDistance, TheLevelOfAnIdIsTheSmallestThatHoldsIt) {
  const Family family = declared_family();
  const std::vector<std::pair<TagId, std::size_t>> levels = {{0, 0}, {3, 0},  {4, 1},
                                                             {9, 1}, {10, 2}, {15, 2}};
  for (const auto& [id, level] : levels) EXPECT_EQ(level_of_id(family, id), level) << id;
}

TEST(IdDistance, AnIdThatTheFamilyLacksIsNamed) {
  const SharedFamily family = find_family("tag16h5");
  try {
    distance_of_ids(*family, std::vector<TagId>{1, 30});
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "id 30 is not in tag16h5, which has ids 0 to 29");
  }
}

}  // namespace
}  // namespace tagmint::codec
