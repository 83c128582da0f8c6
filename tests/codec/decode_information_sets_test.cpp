// The look-up of rotation codes by information sets, beside lists of all tags and of all words.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "decode_lookup.h"
#include "kernels/hamming_kernels.h"
#include "support/fixed_random.h"
#include "support/rotation_codes.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

/// 48 data cells, those of tagCustom48h12.
constexpr const char* kCustom48 =
    "custom:dddddddddd/dbbbbbbbbd/dbwwwwwwbd/dbwddddwbd/dbwdxxdwbd/"
    "dbwdxxdwbd/dbwddddwbd/dbwwwwwwbd/dbbbbbbbbd/dddddddddd";

SharedTagIndex make_index(const RotationCodeParts& parts, const std::string& layout,
                          const std::string& rule = "energy:0.3333") {
  return std::make_shared<const TagIndex>(std::make_shared<const RotationCode>(parts),
                                          parse_layout(layout), parse_complexity(rule));
}

/// `word` with `errors` different bits flipped.
Codeword damaged(Codeword word, int bits, int errors, testing::FixedRandom& random) {
  Codeword flips = 0;
  while (std::popcount(flips) < errors) flips |= Codeword{1} << random.between(0, bits - 1);
  return word ^ flips;
}

/// Compares one level with the reference on the list of its tags, or of `ids` of it, on random
/// words and words near its tags.
void expect_as_listed(const SharedTagIndex& index, std::size_t level, int radius,
                      const std::vector<TagId>& ids, int probes) {
  const RotationCode& code = *index->code();
  std::vector<TagId> all(code.tags(level));
  std::iota(all.begin(), all.end(), 0);
  const std::vector<TagId>& listed = ids.empty() ? all : ids;
  std::vector<Codeword> codewords;
  for (const TagId id : listed) codewords.push_back(index->codeword(id));
  const auto reference = make_brute_force_lookup({codewords, listed, code.bits()}, radius);
  const auto searched = make_information_set_lookup(index, level, ids, radius);
  testing::FixedRandom random(7);
  for (int probe = 0; probe < probes; ++probe) {
    Codeword word = random.bits() & low_mask(code.bits());
    if (probe % 2 == 0) {
      const Codeword tag = codewords[random.bits() % codewords.size()];
      const int errors = std::min(random.between(0, radius + 2), code.bits());
      word = rotate(damaged(tag, code.bits(), errors, random), code.bits(), random.between(0, 3));
    }
    ASSERT_EQ(searched->decode(word), reference->decode(word))
        << "level " << level << ", radius " << radius << ", " << to_hex(word);
  }
}

TEST(DecodeInformationSets, EqualsAListOfTheTagsAtAnyRadiusForSmallCodes) {
  for (const auto& [parts, layout] : {std::pair{test::chain_of_16_bits(), "classic:8"},
                                      std::pair{test::cosets_of_16_bits(), "classic:8"},
                                      std::pair{test::coset_of_25_bits(), "classic:9"},
                                      std::pair{test::chain_of_25_bits(), "classic:9"}}) {
    const SharedTagIndex index = make_index(parts, layout);
    for (std::size_t level = 0; level < parts.levels.size(); ++level) {
      for (int radius = 0; radius <= parts.bits; ++radius) {
        expect_as_listed(index, level, radius, {}, 24);
      }
    }
  }
}

TEST(DecodeInformationSets, EqualsAListOfTheTagsUpToTheSafeRadiusAndBeyond) {
  const SharedTagIndex chain36 = make_index(test::chain_of_36_bits(), "classic:10");
  const std::vector<int> safe36 = {7, 5, 4};
  for (std::size_t level = 0; level < safe36.size(); ++level) {
    for (int radius = 0; radius <= safe36[level] + 3; ++radius) {
      expect_as_listed(chain36, level, radius, {}, 60);
    }
  }
  const SharedTagIndex chain48 = make_index(test::chain_of_48_bits(), kCustom48);
  const std::vector<int> safe48 = {11, 9, 7};
  for (std::size_t level = 0; level < safe48.size(); ++level) {
    for (int radius = 0; radius <= safe48[level] + 2; ++radius) {
      expect_as_listed(chain48, level, radius, {}, 40);
    }
  }
}

TEST(DecodeInformationSets, EqualsAListOfChosenTags) {
  const SharedTagIndex index = make_index(test::chain_of_36_bits(), "classic:10");
  for (const std::vector<TagId>& ids :
       {std::vector<TagId>{0, 5, 59}, std::vector<TagId>{61}, std::vector<TagId>{3, 60, 1999}}) {
    for (const int radius : {0, 2, 5, 9, 12}) expect_as_listed(index, 1, radius, ids, 100);
  }
}

TEST(DecodeInformationSets, RefusesTies) {
  // With a radius of all bits every word is near some tag, and only ties are refused.
  const SharedTagIndex index = make_index(test::chain_of_16_bits(), "classic:8");
  const auto lookup = make_information_set_lookup(index, 3, {}, 16);
  int refused = 0;
  for (Codeword word = 0; word < 0x10000; ++word) refused += !lookup->decode(word);
  EXPECT_GT(refused, 1000);
  EXPECT_LT(refused, 0x10000);
}

/// Calls visit(errors) for each pattern of at most `most` errors in the bits from `first` on.
template <typename Visit>
void visit_errors(int bits, int most, const Visit& visit, Codeword errors = 0, int first = 0) {
  visit(errors);
  if (most == 0) return;
  for (int bit = first; bit < bits; ++bit) {
    visit_errors(bits, most - 1, visit, errors | Codeword{1} << bit, bit + 1);
  }
}

TEST(DecodeInformationSets, FindsSampledTagsOfALargeCodeUnderEveryError) {
  const SharedTagIndex index = make_index(test::chain_of_48_bits(), kCustom48);
  const std::size_t tags = index->code()->tags();
  testing::FixedRandom random(8);
  std::map<int, std::unique_ptr<const Decoder::Lookup>> lookups;
  for (const int radius : {2, 5})
    lookups[radius] = make_information_set_lookup(index, 3, {}, radius);
  std::vector<TagId> ids = {0, 5, 6, 16319, 16320, static_cast<TagId>(tags - 1)};
  for (int i = 0; i < 40; ++i) ids.push_back(static_cast<TagId>(random.bits() % tags));
  for (const TagId id : ids) {
    const Codeword codeword = index->codeword(id);
    int failures = 0;
    visit_errors(48, 2, [&](Codeword errors) {
      for (int turns = 0; turns < 4; ++turns) {
        const Codeword observed = rotate(codeword ^ errors, 48, 4 - turns);
        failures += lookups[2]->decode(observed) != Match{id, std::popcount(errors), turns};
      }
    });
    for (int errors = 3; errors <= 5; ++errors) {
      for (int turns = 0; turns < 4; ++turns) {
        const Codeword observed = rotate(damaged(codeword, 48, errors, random), 48, 4 - turns);
        failures += lookups[5]->decode(observed) != Match{id, errors, turns};
        failures += lookups[2]->decode(observed).has_value();
      }
    }
    ASSERT_EQ(failures, 0) << id;
  }
}

/// All words of a code within `radius` of `word`, by looking at every word: the sums of the first
/// 16 words of the basis are listed, and the others are taken from `word` one after the other.
std::vector<Codeword> words_within(const RotationCode& code, Codeword word, int radius) {
  constexpr int kListed = 16;
  std::vector<Codeword> listed;
  for (std::uint64_t message = 0; message >> kListed == 0; ++message) {
    listed.push_back(code.word(message));
  }
  std::vector<Codeword> near;
  for (std::uint64_t rest = 0; rest << kListed < code.words(); ++rest) {
    const Codeword other = code.word(rest << kListed) ^ code.translation();
    for (std::size_t at = 0; at < listed.size(); ++at) {
      at += first_within(std::span(listed).subspan(at), word ^ other, radius);
      if (at < listed.size()) near.push_back(listed[at] ^ other);
    }
  }
  return near;
}

TEST(DecodeInformationSets, AgreesWithAllWordsOfALargeCodeOnRandomWords) {
  const SharedTagIndex index = make_index(test::chain_of_48_bits(), kCustom48);
  constexpr int kSafe = 5;
  const auto lookup = make_information_set_lookup(index, 3, {}, kSafe);
  testing::FixedRandom random(9);
  int hits = 0;
  for (int probe = 0; probe < 64; ++probe) {
    const Codeword word = random.bits() & low_mask(48);
    const std::vector<Codeword> near = words_within(*index->code(), word, kSafe);
    const std::optional<Match> match = lookup->decode(word);
    ASSERT_LE(near.size(), 1U);
    const bool is_tag = !near.empty() && rotate(near.front(), 48, 2) != near.front();
    ASSERT_EQ(match.has_value(), is_tag) << to_hex(word);
    if (!match) continue;
    ++hits;
    EXPECT_EQ(rotate(near.front(), 48, match->rotation), index->codeword(match->id));
    EXPECT_EQ(match->hamming, hamming_distance(word, near.front()));
  }
  EXPECT_GT(hits, 0) << "about one random word in nine is within 5 bits of the code";
}

TEST(DecodeInformationSets, TakesLittleMemory) {
  const SharedTagIndex index = make_index(test::chain_of_48_bits(), kCustom48);
  for (const int radius : {0, 2, 5}) {
    EXPECT_LT(make_information_set_lookup(index, 3, {}, radius)->table_bytes(), 16U << 20);
  }
}

}  // namespace
}  // namespace tagmint::codec
