#include "tagmint/codec/family_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/generated_families.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

/// tag16h5 with other codewords, rule or levels.
Family like_tag16h5(std::vector<Codeword> codewords, Complexity complexity = {},
                    std::vector<Level> levels = {}) {
  return Family({"wrong",
                 find_family("tag16h5")->layout(),
                 5,
                 std::move(codewords),
                 complexity,
                 {},
                 std::move(levels)});
}

std::vector<Codeword> codewords_of_tag16h5() {
  const auto words = find_family("tag16h5")->codewords();
  return {words.begin(), words.end()};
}

bool proves(const FamilyCheck& check, const std::string& what) {
  return std::any_of(check.proven.begin(), check.proven.end(),
                     [&](const std::string& line) { return line.find(what) != std::string::npos; });
}

TEST(FamilyCheck, ThePublishedFamiliesKeepTheirWord) {
  for (const char* name : {"tag16h5", "tag25h9", "tag36h11", "tag36h10", "tag36h9", "tagCircle21h7",
                           "tagStandard41h12"}) {
    const FamilyCheck check = check_family(*find_family(name));
    EXPECT_FALSE(check.violation) << name << ": " << check.violation->message;
    EXPECT_EQ(check.proven.size(), 5u) << name;
  }
}

TEST(FamilyCheck, TellsWhatItProved) {
  const std::vector<std::string> expected = {
      "the layout looks the same after a quarter turn",
      "no codeword comes twice among 30",
      "every tag is at least 6 bits from its own turns (5 declared)",
      "all 30 tags are at least 5 bits apart in every rotation (5 declared)",
      "every tag has at least 5 rectangles (rectangles:5 declared)",
  };
  EXPECT_EQ(check_family(*find_family("tag16h5")).proven, expected);
}

TEST(FamilyCheck, FindsAPairThatIsTooNearOnlyWhenTurned) {
  const Codeword word = codewords_of_tag16h5()[7];
  const Codeword near = rotate(word, 16, 1) ^ 0x0101;
  ASSERT_GE(hamming_distance(near, word), 5);
  const FamilyCheck check = check_family(like_tag16h5({word, near}));
  ASSERT_TRUE(check.violation);
  EXPECT_EQ(check.violation->ids, (std::vector<TagId>{0, 1}));
  EXPECT_EQ(check.violation->message,
            "tags 0 and 1 are 2 bits apart when tag 1 is turned by 270 degrees; the family "
            "declares 5");
  EXPECT_FALSE(proves(check, "apart in every rotation"));
}

TEST(FamilyCheck, FindsAPairThatIsTooNearAsItStands) {
  std::vector<Codeword> words = codewords_of_tag16h5();
  words[20] = words[3] ^ 0x8000;
  const FamilyCheck check = check_family(like_tag16h5(words));
  ASSERT_TRUE(check.violation);
  EXPECT_EQ(check.violation->message, "tags 3 and 20 are 1 bit apart; the family declares 5");
}

TEST(FamilyCheck, FindsATagThatIsTooNearItsOwnTurns) {
  std::vector<Codeword> words = codewords_of_tag16h5();
  words[4] = 0x0f0f;  // its half turn is itself
  const FamilyCheck check = check_family(like_tag16h5({words[0], words[1], words[4]}));
  ASSERT_TRUE(check.violation);
  EXPECT_EQ(check.violation->ids, std::vector<TagId>{2});
  EXPECT_EQ(check.violation->message,
            "tag 2 is 0 bits from one of its own turns; the family declares 5");
  EXPECT_FALSE(proves(check, "from its own turns"));
}

TEST(FamilyCheck, FindsATagThatIsTooPlain) {
  const FamilyCheck rectangles =
      check_family(like_tag16h5({0x231b, 0x000f}, {ComplexityRule::Rectangles, 5}));
  ASSERT_TRUE(rectangles.violation);
  EXPECT_EQ(rectangles.violation->ids, std::vector<TagId>{1});
  EXPECT_EQ(rectangles.violation->message,
            "tag 1 is too plain: it has 3 rectangles, the family declares 5 rectangles");
  EXPECT_TRUE(proves(rectangles, "apart in every rotation"));

  const FamilyCheck energy = check_family(like_tag16h5({0x000f}, {ComplexityRule::Energy, 0.5}));
  ASSERT_TRUE(energy.violation);
  EXPECT_NE(energy.violation->message.find("the family declares energy 0.5000"), std::string::npos);
}

TEST(FamilyCheck, FindsALevelThatDeclaresTooMuch) {
  const std::vector<Codeword> words = codewords_of_tag16h5();
  // The least distance among the first ten tags is what it is; a level may declare that, not more.
  int least = 16;
  for (int i = 0; i < 10; ++i) {
    least = std::min(least, self_distance(words[i], 16));
    for (int j = i + 1; j < 10; ++j)
      least = std::min(least, rotation_distance(words[i], words[j], 16));
  }
  ASSERT_EQ(least, 5);
  const FamilyCheck check = check_family(like_tag16h5(words, {}, {{10, 6}, {30, 5}}));
  ASSERT_TRUE(check.violation);
  EXPECT_NE(check.violation->message.find("; its first 10 ids declare 6"), std::string::npos)
      << check.violation->message;
  EXPECT_LT(check.violation->ids.back(), 10u);
  EXPECT_FALSE(proves(check, "the first 10 tags"));
  EXPECT_TRUE(proves(check, "all 30 tags are at least 5 bits apart"));
}

TEST(FamilyCheck, ProvesEachLevel) {
  // Tags 0 and 1 of this family are farther apart than the rest.
  const std::vector<Codeword> words = codewords_of_tag16h5();
  std::vector<Codeword> chosen;
  for (std::size_t i = 0; i < words.size() && chosen.empty(); ++i) {
    for (std::size_t j = i + 1; j < words.size() && chosen.empty(); ++j) {
      if (rotation_distance(words[i], words[j], 16) == 6 && self_distance(words[i], 16) >= 6 &&
          self_distance(words[j], 16) >= 6) {
        chosen = {words[i], words[j]};
      }
    }
  }
  ASSERT_EQ(chosen.size(), 2u);
  for (const Codeword word : words) {
    if (word != chosen[0] && word != chosen[1]) chosen.push_back(word);
  }
  const FamilyCheck check = check_family(like_tag16h5(chosen, {}, {{2, 6}, {30, 5}}));
  EXPECT_FALSE(check.violation);
  EXPECT_TRUE(proves(check, "the first 2 tags are at least 6 bits apart"));
}

TEST(FamilyCheck, PlainTagsOfALevelMustFailTheRule) {
  // Sorted so that the plain ones of each half come last.
  const Complexity rule{ComplexityRule::Energy, 0.34};
  const ComplexityJudge judge(find_family("tag16h5")->layout(), rule);
  std::vector<Codeword> words = codewords_of_tag16h5();
  const auto passes = [&](Codeword word) { return judge.accepts(word); };
  const auto passing = std::stable_partition(words.begin(), words.end(), passes) - words.begin();
  ASSERT_GT(passing, 2);
  ASSERT_LT(passing, 28);
  const auto plain = static_cast<std::size_t>(30 - passing);
  const FamilyCheck sound = check_family(like_tag16h5(words, rule, {{30, 5, plain}}));
  EXPECT_FALSE(sound.violation) << sound.violation->message;
  EXPECT_TRUE(proves(sound, "the " + std::to_string(plain) + " plain ones less"));

  const FamilyCheck fewer = check_family(like_tag16h5(words, rule, {{30, 5, plain - 1}}));
  ASSERT_TRUE(fewer.violation);
  EXPECT_EQ(fewer.violation->ids, std::vector<TagId>{static_cast<TagId>(passing)});
  EXPECT_NE(fewer.violation->message.find("is too plain"), std::string::npos);

  const FamilyCheck more = check_family(like_tag16h5(words, rule, {{30, 5, plain + 1}}));
  ASSERT_TRUE(more.violation);
  EXPECT_EQ(more.violation->ids, std::vector<TagId>{static_cast<TagId>(passing - 1)});
  EXPECT_NE(more.violation->message.find("is declared plain, but it has energy"),
            std::string::npos);
  EXPECT_NE(more.violation->message.find("enough for energy:0.34"), std::string::npos);
}

TEST(FamilyCheck, ProvesGeneratedFamilies) {
  FamilyParts parts = test::generated_36();
  parts.declared_digest = family_digest(Family(parts));
  const FamilyCheck check = check_family(Family(parts));
  EXPECT_FALSE(check.violation) << check.violation->message;
  const std::vector<std::string> expected = {
      "the layout looks the same after a quarter turn",
      "the 19 words of the basis are independent",
      "each of the 4 levels is closed under quarter turns and has as many tags as declared",
      "every tag is at least 8 bits from its own turns (8 declared)",
      "the first 60 tags are at least 16 bits apart in every rotation (16 declared)",
      "the first 2016 tags are at least 12 bits apart in every rotation (12 declared)",
      "the first 8128 tags are at least 10 bits apart in every rotation (10 declared)",
      "all 130816 tags are at least 8 bits apart in every rotation (8 declared)",
      "121100 of 130816 tags have at least energy 0.3400 (energy:0.3333 declared), the 9716 plain "
      "ones less",
      "the SHA-256 of all 130816 codewords is the declared one",
  };
  EXPECT_EQ(check.proven, expected);
  for (const FamilyParts& small : {test::generated_16(), test::generated_25()}) {
    EXPECT_FALSE(check_family(Family(small)).violation);
  }
}

TEST(FamilyCheck, FindsALevelOfAGeneratedFamilyThatDeclaresTooMuch) {
  FamilyParts parts = test::generated_36();
  parts.levels[1].min_hamming = 13;
  const FamilyCheck check = check_family(Family(parts));
  ASSERT_TRUE(check.violation);
  EXPECT_TRUE(proves(check, "the first 60 tags"));
  EXPECT_FALSE(proves(check, "the first 2016 tags"));
  EXPECT_TRUE(proves(check, "all 130816 tags"));
  const std::vector<TagId>& ids = check.violation->ids;
  EXPECT_LT(ids.back(), 2016u);
  const Family family(parts);
  if (ids.size() == 1) {
    EXPECT_EQ(self_distance(family.codeword(ids[0]), 36), 12);
  } else {
    EXPECT_EQ(rotation_distance(family.codeword(ids[0]), family.codeword(ids[1]), 36), 12);
  }
  EXPECT_NE(check.violation->message.find("; its first 2016 ids declare 13"), std::string::npos)
      << check.violation->message;

  parts = test::generated_25();
  parts.min_hamming = 10;
  EXPECT_TRUE(check_family(Family(parts)).violation);
}

TEST(FamilyCheck, FindsWrongPlainTagsAndDigestsOfGeneratedFamilies) {
  FamilyParts parts = test::generated_36();
  parts.declared_digest = std::string(64, '0');
  const FamilyCheck digest = check_family(Family(parts));
  ASSERT_TRUE(digest.violation);
  EXPECT_TRUE(digest.violation->ids.empty());
  EXPECT_NE(digest.violation->message.find("the family declares 0000"), std::string::npos);

  ++parts.levels[1].plain;
  const FamilyCheck plain = check_family(Family(parts));
  ASSERT_TRUE(plain.violation);
  EXPECT_EQ(plain.violation->ids, std::vector<TagId>{2016 - 132 - 1}) << "before the digest";
  EXPECT_NE(plain.violation->message.find("is declared plain"), std::string::npos);
}

/// The lowest ids at fault, found by trying all.
std::vector<TagId> first_at_fault(const std::vector<Codeword>& words, int min_hamming) {
  for (TagId i = 0; i < words.size(); ++i) {
    if (self_distance(words[i], 16) < min_hamming) return {i};
    for (TagId j = i + 1; j < words.size(); ++j) {
      if (rotation_distance(words[i], words[j], 16) < min_hamming) return {i, j};
    }
  }
  return {};
}

TEST(FamilyCheck, TellsTheViolationWithTheLowestIds) {
  for (const TagId even : {0u, 1u, 4u, 29u}) {
    for (const TagId near : {2u, 5u, 17u}) {
      std::vector<Codeword> words = codewords_of_tag16h5();
      words[even] = 0x0f0f;
      words[near + 6] = words[near] ^ 1;
      for (const int threads : {1, 4}) {
        const FamilyCheck check = check_family(like_tag16h5(words), threads);
        ASSERT_TRUE(check.violation);
        EXPECT_EQ(check.violation->ids, first_at_fault(words, 5));
      }
    }
  }
}

}  // namespace
}  // namespace tagmint::codec
