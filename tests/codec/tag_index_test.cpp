#include "tagmint/codec/tag_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/fixed_random.h"
#include "support/rotation_codes.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

using Address = RotationCode::Address;

/// A code, the layout that its words are drawn on and the rule that orders its tags.
struct Case {
  RotationCodeParts code;
  std::string layout;
  std::string rule;
};

SharedRotationCode make_code(const RotationCodeParts& parts) {
  return std::make_shared<const RotationCode>(parts);
}

TagIndex make_index(const Case& one) {
  return {make_code(one.code), parse_layout(one.layout), parse_complexity(one.rule)};
}

/// The tags of a code in id order and the plain ones of each level, by looking at every word.
struct PlainListing {
  explicit PlainListing(const Case& one) {
    const RotationCode code(one.code);
    const ComplexityJudge judge(parse_layout(one.layout), parse_complexity(one.rule));
    std::set<Codeword> seen;  // words of the levels so far, in every turn
    for (const RotationCodeLevel& level : code.levels()) {
      std::vector<Codeword> accepted;
      std::vector<Codeword> failed;
      for (Address coset = 0; coset < level.cosets; ++coset) {
        for (Address message = 0; message < Address{1} << level.dimension; ++message) {
          const Codeword word = code.word(coset << code.dimension() | message);
          if (seen.contains(word)) continue;
          for (int turn = 0; turn < 4; ++turn) seen.insert(rotate(word, code.bits(), turn));
          if (rotate(word, code.bits(), 2) == word) continue;
          (judge.accepts(word) ? accepted : failed).push_back(word);
        }
      }
      codewords.insert(codewords.end(), accepted.begin(), accepted.end());
      codewords.insert(codewords.end(), failed.begin(), failed.end());
      plain.push_back(failed.size());
    }
  }

  std::vector<Codeword> codewords;
  std::vector<std::size_t> plain;
};

std::vector<Case> small_cases() {
  RotationCodeParts half_36 = test::chain_of_36_bits();
  half_36.basis.resize(15);
  half_36.levels = {{8}, {13}, {15}};
  RotationCodeParts inner_48 = test::chain_of_48_bits();
  inner_48.basis.resize(16);
  inner_48.levels = {{5}, {9}, {16}};
  return {
      {test::chain_of_16_bits(), "classic:8", "energy:0.3333"},
      {test::chain_of_16_bits(), "classic:8", "rectangles:5"},
      {test::chain_of_16_bits(), "classic:8", "none"},
      {test::cosets_of_16_bits(), "classic:8", "energy:0.38"},
      {test::chain_of_25_bits(), "classic:9", "rectangles:8"},
      {test::chain_of_25_bits(), "classic:9", "energy:0.35"},
      {test::coset_of_25_bits(), "classic:9", "energy:0.3333"},
      {half_36, "classic:10", "energy:0.3333"},
      {inner_48,
       "custom:dddddddddd/dbbbbbbbbd/dbwwwwwwbd/dbwddddwbd/dbwdxxdwbd/dbwdxxdwbd/"
       "dbwddddwbd/dbwwwwwwbd/dbbbbbbbbd/dddddddddd",
       "energy:0.3333"},
  };
}

TEST(TagIndex, NumbersTagsAsAPlainListingDoes) {
  for (const Case& one : small_cases()) {
    SCOPED_TRACE(one.layout + " " + one.rule);
    const PlainListing listing(one);
    const TagIndex index = make_index(one);
    ASSERT_EQ(index.code()->tags(), listing.codewords.size());
    for (TagId id = 0; id < listing.codewords.size(); ++id) {
      ASSERT_EQ(index.codeword(id), listing.codewords[id]) << id;
    }
    for (std::size_t level = 0; level < listing.plain.size(); ++level) {
      EXPECT_EQ(index.plain(level), listing.plain[level]) << level;
    }
  }
}

TEST(TagIndex, FindsEachTagInEveryTurn) {
  for (const Case& one : small_cases()) {
    SCOPED_TRACE(one.layout + " " + one.rule);
    const TagIndex index = make_index(one);
    const int bits = index.code()->bits();
    for (TagId id = 0; id < index.code()->tags(); ++id) {
      const Codeword word = index.codeword(id);
      for (int turns = 0; turns < 4; ++turns) {
        ASSERT_EQ(index.find(rotate(word, bits, -turns)), (TagIndex::Place{id, turns}));
      }
    }
  }
}

TEST(TagIndex, FindsNothingForWordsThatAreNoTag) {
  const TagIndex index = make_index({test::chain_of_16_bits(), "classic:8", "none"});
  std::size_t short_orbits = 0;
  for (Codeword word = 0; word < 1 << 16; ++word) {
    const bool of_code = index.code()->find(word).has_value();
    const bool same_after_half = rotate(word, 16, 2) == word;
    ASSERT_EQ(index.find(word).has_value(), of_code && !same_after_half) << word;
    short_orbits += of_code && same_after_half;
  }
  EXPECT_EQ(short_orbits, 512u - 4 * 120);
}

TEST(TagIndex, CountsThePlainTagsOfLargeCodes) {
  const TagIndex index = make_index({test::chain_of_36_bits(), "classic:10", "energy:0.3333"});
  std::vector<std::size_t> accepted;
  std::size_t plain = 0;
  for (std::size_t level = 0; level < 4; ++level) {
    plain += index.plain(level);
    accepted.push_back(index.code()->tags(level) - plain);
  }
  EXPECT_EQ(accepted, (std::vector<std::size_t>{60, 1884, 7531, 121100}));
}

TEST(TagIndex, ServesMillionsOfTags) {
  const SharedFamily published = find_family("tagCustom48h12");
  const TagIndex index(make_code(test::chain_of_48_bits()), published->layout(),
                       parse_complexity("energy:0.3333"));
  const ComplexityJudge judge(published->layout(), parse_complexity("energy:0.3333"));
  std::size_t plain = 0;
  for (std::size_t level = 0; level < 4; ++level) plain += index.plain(level);
  EXPECT_EQ(index.code()->tags() - plain, 3963257u);
  EXPECT_LT(index.table_bytes(3), std::size_t{8} << 20);

  const TagId first_plain = static_cast<TagId>(index.code()->tags() - index.plain(3));
  testing::FixedRandom random(3);
  Address last_address = 0;
  for (TagId id = 16320; id < index.code()->tags(); id += 997) {
    const Codeword word = index.codeword(id);
    ASSERT_EQ(judge.accepts(word), id < first_plain) << id;
    const int turns = random.between(0, 3);
    ASSERT_EQ(index.find(rotate(word, 48, -turns)), (TagIndex::Place{id, turns}));
    const Address address = index.code()->find(word).value();
    if (id >= 16320 + 997 && (id < first_plain || id - 997 >= first_plain)) {
      ASSERT_GT(address, last_address) << id;
    }
    last_address = address;
  }
}

TEST(TagIndex, MayBeUsedFirstBySeveralThreadsAtOnce) {
  const Case one{test::chain_of_36_bits(), "classic:10", "energy:0.3333"};
  const TagIndex alone = make_index(one);
  const TagIndex shared = make_index(one);
  const auto size = static_cast<TagId>(alone.code()->tags());
  std::vector<std::size_t> wrong(4, 0);
  {
    std::vector<std::jthread> threads;
    for (std::size_t thread = 0; thread < wrong.size(); ++thread) {
      threads.emplace_back([&, thread] {
        for (TagId i = 0; i < size; i += 101) {
          const TagId id = thread % 2 == 0 ? i : size - 1 - i;
          const Codeword word = shared.codeword(id);
          wrong[thread] += shared.find(word) != TagIndex::Place{id, 0};
          wrong[thread] += word != alone.codeword(id);
        }
      });
    }
  }
  EXPECT_EQ(wrong, std::vector<std::size_t>(4, 0));
}

TEST(TagIndex, RefusesACodeThatDoesNotFit) {
  const Layout layout = parse_layout("classic:8");
  EXPECT_THROW(TagIndex(nullptr, layout, {}), std::invalid_argument);
  try {
    const TagIndex index(make_code(test::chain_of_25_bits()), layout, {});
    FAIL() << "25 bits on 16 cells";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "words of 25 bits do not fit a layout with 16 data cells");
  }
}

}  // namespace
}  // namespace tagmint::codec
