#include "tagmint/codec/decoder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "support/generated_families.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/id_distance.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

DecoderOptions with(DecoderEngine engine, int max_errors, bool unsafe = false) {
  DecoderOptions options;
  options.engine = engine;
  options.max_errors = max_errors;
  options.allow_unsafe_radius = unsafe;
  return options;
}

/// The nearest tag as the header describes it, from nothing but rotation.h.
std::optional<Match> nearest_by_definition(const Family& family, Codeword observed,
                                           int max_errors) {
  std::optional<Match> best;
  bool tie = false;
  for (TagId id = 0; id < family.size(); ++id) {
    for (int turns = 0; turns < 4; ++turns) {
      const int distance =
          hamming_distance(rotate(observed, family.bits(), turns), family.codeword(id));
      if (distance > max_errors || (best && distance > best->hamming)) continue;
      if (!best || distance < best->hamming) {
        tie = false;
        best = Match{id, distance, turns};
      } else if (id != best->id) {
        tie = true;
      } else {
        best->rotation = std::min(best->rotation, turns);
      }
    }
  }
  return tie ? std::nullopt : best;
}

/// Checks that every word within two errors of codeword `id`, in all four turns, is recognised.
/// Returns the number of failures, so that millions of words cost no millions of assertions.
int failures_around(const Decoder& decoder, TagId id) {
  const int bits = decoder.family()->bits();
  const Codeword codeword = decoder.family()->codeword(id);
  int failures = 0;
  const auto expect_decoded = [&](Codeword damaged, int errors) {
    for (int turns = 0; turns < 4; ++turns) {
      // Turned back by as much as the decoder has to turn it on.
      const Codeword observed = rotate(damaged, bits, 4 - turns);
      failures += decoder.decode(observed) != Match{id, errors, turns};
    }
  };
  expect_decoded(codeword, 0);
  for (int i = 0; i < bits; ++i) {
    const Codeword one = codeword ^ (Codeword{1} << i);
    expect_decoded(one, 1);
    for (int j = i + 1; j < bits; ++j) expect_decoded(one ^ (Codeword{1} << j), 2);
  }
  return failures;
}

class EveryCodeword : public testing::TestWithParam<std::tuple<const char*, DecoderEngine>> {};

TEST_P(EveryCodeword, IsFoundUnderEveryTwoErrorsInEveryTurn) {
  const auto& [name, engine] = GetParam();
  const Decoder decoder(find_family(name), with(engine, 2));
  for (TagId id = 0; id < decoder.family()->size(); ++id) {
    ASSERT_EQ(failures_around(decoder, id), 0) << name << " id " << id;
  }
}

INSTANTIATE_TEST_SUITE_P(
    UpTo36Bits, EveryCodeword,
    testing::Combine(testing::Values("tag16h5", "tag25h9", "tag36h10", "tag36h11", "tagCircle21h7"),
                     testing::Values(DecoderEngine::Hash, DecoderEngine::Chunks)),
    [](const auto& info) {
      const bool hash = std::get<1>(info.param) == DecoderEngine::Hash;
      return std::string(std::get<0>(info.param)) + (hash ? "Hash" : "Chunks");
    });

TEST(Decoder, FindsCodewordsOfLargeFamiliesUnderTwoErrors) {
  for (const char* name :
       {"tagStandard41h12", "tagCustom48h12", "tagCircle49h12", "tagStandard52h13"}) {
    const Decoder decoder(find_family(name));
    ASSERT_EQ(decoder.max_errors(), 2);
    const auto size = static_cast<TagId>(decoder.family()->size());
    for (TagId id = size / 11; id < size; id += size / 11) {
      EXPECT_EQ(failures_around(decoder, id), 0) << name << " id " << id;
    }
    EXPECT_EQ(failures_around(decoder, size - 1), 0) << name << ", the last id";
  }
}

TEST(Decoder, CorrectsUpToTheSafeRadiusOfLargeFamilies) {
  std::mt19937_64 random(2);
  const SharedFamily family = find_family("tagStandard52h13");
  const Decoder decoder(family, with(DecoderEngine::Auto, 6));
  EXPECT_EQ(decoder.engine(), DecoderEngine::Chunks);
  for (int i = 0; i < 2000; ++i) {
    const auto id = static_cast<TagId>(random() % family->size());
    Codeword damaged = family->codeword(id);
    const int errors = static_cast<int>(random() % 7);
    while (hamming_distance(damaged, family->codeword(id)) < errors) {
      damaged ^= Codeword{1} << (random() % 52);
    }
    const int turns = static_cast<int>(random() % 4);
    ASSERT_EQ(decoder.decode(rotate(damaged, 52, 4 - turns)), (Match{id, errors, turns}));
  }
}

/// What the constructor says against these options.
std::string refusal_of(const SharedFamily& family, const DecoderOptions& options) {
  try {
    const Decoder decoder(family, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

/// Random words, and words a few bits away from some turn of a tag.
std::vector<Codeword> probe_words(const Family& family, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Codeword> words;
  for (int i = 0; i < count; ++i) {
    words.push_back(random() & low_mask(family.bits()));
    Codeword near = rotate(family.codeword(static_cast<TagId>(random() % family.size())),
                           family.bits(), static_cast<int>(random() % 4));
    for (auto flips = random() % 8; flips > 0; --flips) {
      near ^= Codeword{1} << (random() % static_cast<unsigned>(family.bits()));
    }
    words.push_back(near);
  }
  return words;
}

TEST(Decoder, AllEnginesGiveTheNearestTag) {
  for (const char* name : {"tag16h5", "tag25h9", "tagCircle21h7", "tag36h11"}) {
    const SharedFamily family = find_family(name);
    for (int radius = 0; radius <= family->max_safe_errors(); ++radius) {
      const Decoder brute(family, with(DecoderEngine::BruteForce, radius));
      const Decoder chunks(family, with(DecoderEngine::Chunks, radius));
      const Decoder hash(family, with(DecoderEngine::Hash, std::min(radius, 2)));
      for (const Codeword word : probe_words(*family, 400, 3)) {
        const auto expected = nearest_by_definition(*family, word, radius);
        ASSERT_EQ(brute.decode(word), expected) << name << " " << to_hex(word);
        ASSERT_EQ(chunks.decode(word), expected) << name << " " << to_hex(word);
        if (radius <= 2) {
          ASSERT_EQ(hash.decode(word), expected) << name << " " << to_hex(word);
        }
      }
    }
  }
}

TEST(Decoder, AllEnginesRefuseTheSameTiesBeyondTheSafeRadius) {
  const SharedFamily family = find_family("tag16h5");
  int ties = 0;
  for (int radius = 3; radius <= 16; ++radius) {
    const Decoder brute(family, with(DecoderEngine::BruteForce, radius, true));
    const Decoder chunks(family, with(DecoderEngine::Chunks, radius, true));
    for (const Codeword word : probe_words(*family, 300, 4)) {
      const auto expected = nearest_by_definition(*family, word, radius);
      ties += !expected && radius == 16;
      ASSERT_EQ(brute.decode(word), expected) << radius << " " << to_hex(word);
      ASSERT_EQ(chunks.decode(word), expected) << radius << " " << to_hex(word);
    }
  }
  EXPECT_GT(ties, 50) << "with radius 16 nothing but a tie is refused";
}

TEST(Decoder, TheHashRefusesTiesBeyondTheSafeRadius) {
  // Two tags three bits apart, so that a radius of 2 is one too many.
  const auto family = std::make_shared<const Family>(
      FamilyParts{"near", classic_layout(8), 3, {0x231b, 0x231b ^ 0x0111, 0x2ea5}, {}, {}, {}});
  const Decoder hash(family, with(DecoderEngine::Hash, 2, true));
  int refused = 0;
  for (Codeword word = 0; word < 0x10000; ++word) {
    const auto expected = nearest_by_definition(*family, word, 2);
    ASSERT_EQ(hash.decode(word), expected) << to_hex(word);
    refused += !expected;
  }
  EXPECT_GT(refused, 0);
}

TEST(Decoder, ATagThatEqualsItsOwnTurnIsFoundWithTheFewestTurns) {
  const auto family = std::make_shared<const Family>(
      FamilyParts{"even", classic_layout(8), 1, {0x0f0f}, {}, {}, {}});
  const Decoder decoder(family);
  EXPECT_EQ(decoder.decode(0x0f0f), (Match{0, 0, 0}));
  EXPECT_EQ(decoder.decode(0xf0f0), (Match{0, 0, 1}));
}

TEST(Decoder, EnginesAgreeOnEveryWordOfASmallLayout) {
  for (const char* layout : {"classic:5", "classic:6"}) {
    for (const Codeword codeword : {Codeword{0}, Codeword{1}}) {
      const auto family = std::make_shared<const Family>(
          FamilyParts{"tiny", parse_layout(layout), 1, {codeword}, {}, {}, {}});
      for (int radius = 0; radius <= family->bits(); ++radius) {
        const Decoder chunks(family, with(DecoderEngine::Chunks, radius, true));
        for (Codeword word = 0; word <= low_mask(family->bits()); ++word) {
          EXPECT_EQ(chunks.decode(word), nearest_by_definition(*family, word, radius));
        }
      }
    }
  }
}

TEST(Decoder, Handles64Bits) {
  std::mt19937_64 random(5);
  const auto family = std::make_shared<const Family>(FamilyParts{
      "wide", classic_layout(12), 5, {random(), random(), ~Codeword{0} << 32}, {}, {}, {}});
  for (const DecoderEngine engine : {DecoderEngine::Hash, DecoderEngine::Chunks}) {
    for (const int radius : {0, 2}) {
      const Decoder decoder(family, with(engine, radius));
      for (const Codeword word : probe_words(*family, 300, 6)) {
        EXPECT_EQ(decoder.decode(word), nearest_by_definition(*family, word, radius));
      }
    }
  }
}

TEST(Decoder, RecognisesChosenIdsOnly) {
  const SharedFamily family = find_family("tag36h11");
  for (const DecoderEngine engine :
       {DecoderEngine::BruteForce, DecoderEngine::Hash, DecoderEngine::Chunks}) {
    DecoderOptions options = with(engine, 2);
    options.ids = {586, 3, 3, 40};
    Decoder made(family, options);
    const Decoder decoder = std::move(made);  // look-ups survive a move
    for (TagId id = 0; id < family->size(); ++id) {
      const auto match = decoder.decode(family->codeword(id) ^ 1);
      const bool chosen = id == 3 || id == 40 || id == 586;
      EXPECT_EQ(match, chosen ? std::optional(Match{id, 1, 0}) : std::nullopt);
    }
  }
}

TEST(Decoder, ChosenIdsHaveTheirOwnSafeRadius) {
  // Ids of tag36h11 that are at least 14 bits apart, and from their own turns.
  const SharedFamily family = find_family("tag36h11");
  DecoderOptions options;
  for (TagId id = 0; id < family->size() && options.ids.size() < 6; ++id) {
    options.ids.push_back(id);
    if (distance_of_ids(*family, options.ids) < 14) options.ids.pop_back();
  }
  ASSERT_EQ(options.ids.size(), 6U);
  EXPECT_EQ(Decoder(family).min_hamming(), 11);
  EXPECT_EQ(Decoder(family).max_safe_errors(), 5);
  options.max_errors = 6;
  const Decoder decoder(family, options);
  EXPECT_EQ(decoder.min_hamming(), 14);
  EXPECT_EQ(decoder.max_safe_errors(), 6);
  for (const TagId id : options.ids) {
    const Codeword observed = family->codeword(id) ^ 0x90a000840;
    EXPECT_EQ(decoder.decode(observed), (Match{id, 6, 0}));
  }
}

TEST(Decoder, ChoosesTheHashWhileItsTableIsSmall) {
  const Decoder small(find_family("tag25h9"));
  EXPECT_EQ(small.engine(), DecoderEngine::Hash);
  EXPECT_EQ(small.table_bytes(), 35U * 326 * 2 * 2);
  EXPECT_EQ(Decoder::hash_table_bytes(*small.family(), 2), small.table_bytes());
  EXPECT_LE(small.table_bytes(), Decoder::kMostHashBytes);
  EXPECT_THROW(Decoder::hash_table_bytes(*small.family(), 3), std::invalid_argument);
  EXPECT_EQ(Decoder(find_family("tag25h9"), with(DecoderEngine::Auto, 3)).engine(),
            DecoderEngine::Chunks);
  EXPECT_GT(Decoder::hash_table_bytes(*find_family("tag36h11"), 2), Decoder::kMostHashBytes);
  EXPECT_EQ(Decoder(find_family("tag36h11")).engine(), DecoderEngine::Chunks);
  EXPECT_EQ(Decoder(find_family("tag36h11"), with(DecoderEngine::Auto, 0)).engine(),
            DecoderEngine::Hash);
}

TEST(Decoder, TablesOfTwoErrorsTakeATenthAndAHundredthOfThePublishedOne) {
  // The published table holds each word within two errors, at 16 bytes, and two slots of three are
  // empty.
  const auto published_bytes = [](const Family& family) {
    const std::size_t n = static_cast<std::size_t>(family.bits());
    return family.size() * (1 + n + n * (n - 1) / 2) * 3 * 16;
  };
  const SharedFamily middle = find_family("tag36h11");
  for (const DecoderEngine engine : {DecoderEngine::Hash, DecoderEngine::Chunks}) {
    EXPECT_LT(Decoder(middle, with(engine, 2)).table_bytes() * 10, published_bytes(*middle));
  }
  const SharedFamily large = find_family("tagStandard52h13");
  EXPECT_LT(Decoder(large).table_bytes() * 100, published_bytes(*large));
}

/// `count` random tags of 48 bits; their distance is what it happens to be.
SharedFamily random_family(std::size_t count) {
  std::mt19937_64 random(21);
  std::vector<Codeword> codewords;
  for (std::size_t i = 0; i < count; ++i) codewords.push_back(random() & low_mask(48));
  return std::make_shared<const Family>(FamilyParts{
      "random", find_family("tagCustom48h12")->layout(), 1, std::move(codewords), {}, {}, {}});
}

TEST(Decoder, IdsAbove65535AreRecognisedByAllEngines) {
  constexpr TagId kTags = 70000;
  const SharedFamily family = random_family(kTags);
  DecoderOptions few = with(DecoderEngine::Hash, 2, true);
  few.ids = {5, 65535, 65536, kTags - 1};  // an entry for each word of all would take gigabytes
  const Decoder hash(family, few);
  const Decoder whole_hash(family, with(DecoderEngine::Hash, 0, true));
  const Decoder chunks(family, with(DecoderEngine::Chunks, 2, true));
  const Decoder brute(family, with(DecoderEngine::BruteForce, 2, true));
  std::mt19937_64 random(22);
  for (const TagId id : few.ids) {
    const Codeword word = family->codeword(id);
    const Codeword observed = rotate(word ^ 0x800000000001, 48, 3);
    EXPECT_EQ(hash.decode(observed), (Match{id, 2, 1}));
    EXPECT_EQ(chunks.decode(observed), (Match{id, 2, 1}));
    EXPECT_EQ(brute.decode(observed), (Match{id, 2, 1}));
    EXPECT_EQ(whole_hash.decode(word), (Match{id, 0, 0}));
  }
  for (const Codeword word : probe_words(*family, 100, 23)) {
    EXPECT_EQ(chunks.decode(word), brute.decode(word)) << to_hex(word);
  }
}

TEST(Decoder, RefusesTagsThatAreTurnsOfEachOther) {
  const Codeword word = 0x231b;
  const auto family = std::make_shared<const Family>(
      FamilyParts{"turned", classic_layout(8), 1, {word, rotate(word, 16, 1), 0x2ea5}, {}, {}, {}});
  for (const DecoderEngine engine :
       {DecoderEngine::BruteForce, DecoderEngine::Hash, DecoderEngine::Chunks}) {
    for (int radius = 0; radius <= 2; ++radius) {
      const Decoder decoder(family, with(engine, radius, true));
      EXPECT_EQ(decoder.decode(word), std::nullopt);
      EXPECT_EQ(decoder.decode(0x2ea5), (Match{2, 0, 0}));
    }
  }
}

TEST(Decoder, EnginesAgreeOnWordsThatEqualTheirOwnTurns) {
  // Tags near such words, so that several turns of one word are as near to one tag.
  const auto family = std::make_shared<const Family>(FamilyParts{
      "symmetric", classic_layout(8), 1, {0x0f0e, 0x3333 ^ 0x0100, 0xa5a5}, {}, {}, {}});
  for (int radius = 0; radius <= 2; ++radius) {
    const Decoder hash(family, with(DecoderEngine::Hash, radius, true));
    const Decoder chunks(family, with(DecoderEngine::Chunks, radius, true));
    for (Codeword word = 0; word < 0x10000; ++word) {
      const auto expected = nearest_by_definition(*family, word, radius);
      ASSERT_EQ(hash.decode(word), expected) << radius << " " << to_hex(word);
      ASSERT_EQ(chunks.decode(word), expected) << radius << " " << to_hex(word);
    }
  }
}

TEST(Decoder, ServesManyThreadsAtOnce) {
  const SharedFamily family = find_family("tag36h11");
  const auto generated = std::make_shared<const Family>(test::generated_36());
  const std::vector<Codeword> words = probe_words(*family, 500, 31);
  for (const auto& [tags, engine] : {std::pair{family, DecoderEngine::BruteForce},
                                     {family, DecoderEngine::Hash},
                                     {family, DecoderEngine::Chunks},
                                     {SharedFamily(generated), DecoderEngine::InformationSets}}) {
    const auto decoder = std::make_shared<const Decoder>(tags, with(engine, 2));
    std::vector<std::optional<Match>> expected;
    // A decoder of its own, so that the shared one is new to all threads.
    const Decoder alone(tags, with(engine, 2));
    for (const Codeword word : words) expected.push_back(alone.decode(word));
    std::vector<std::vector<std::optional<Match>>> seen(4);
    {
      std::vector<std::jthread> threads;
      for (auto& matches : seen) {
        threads.emplace_back([&words, decoder, &matches] {
          for (const Codeword word : words) matches.push_back(decoder->decode(word));
        });
      }
    }
    for (const auto& matches : seen) EXPECT_EQ(matches, expected);
  }
}

TEST(Decoder, CorrectsTwoErrorsOrTheSafeRadiusUnlessTold) {
  EXPECT_EQ(Decoder(find_family("tag36h11")).max_errors(), 2);
  const auto family = std::make_shared<const Family>(
      FamilyParts{"weak", classic_layout(8), 3, {0x231b}, {}, {}, {}});
  EXPECT_EQ(Decoder(family).max_errors(), 1);
}

TEST(Decoder, AllEnginesReadGeneratedFamiliesAlike) {
  const auto family = std::make_shared<const Family>(test::generated_36());
  const auto list = std::make_shared<const Family>(test::listed(*family));
  for (const auto& [ids, radius] : {std::pair{60U, 7}, std::pair{2016U, 5}, std::pair{0U, 3}}) {
    DecoderOptions options;
    for (TagId id = 0; id < ids; ++id) options.ids.push_back(id);
    options.max_errors = radius;
    const Decoder listed(list, options);
    options.engine = DecoderEngine::Chunks;
    const Decoder chunks(family, options);
    options.engine = DecoderEngine::InformationSets;
    const Decoder sets(family, options);
    for (const Codeword word : probe_words(*family, 2000, 11)) {
      ASSERT_EQ(sets.decode(word), listed.decode(word)) << ids << " " << to_hex(word);
      ASSERT_EQ(chunks.decode(word), listed.decode(word)) << ids << " " << to_hex(word);
    }
    options.max_errors = std::min(radius, 2);
    options.engine = DecoderEngine::Hash;
    if (ids == 0) continue;  // a quarter of a gigabyte
    const Decoder hash(family, options);
    for (const Codeword word : probe_words(*family, 2000, 12)) {
      const auto match = sets.decode(word);
      ASSERT_EQ(hash.decode(word), match && match->hamming <= 2 ? match : std::nullopt);
    }
  }
}

TEST(Decoder, ALevelsIdsAreReadUpToTheLevelsSafeRadius) {
  const auto family = std::make_shared<const Family>(test::generated_36());
  DecoderOptions options;
  for (TagId id = 0; id < 60; ++id) options.ids.push_back(id);
  options.max_errors = 7;
  const Decoder decoder(family, options);
  EXPECT_EQ(decoder.engine(), DecoderEngine::InformationSets);
  EXPECT_EQ(decoder.min_hamming(), 16);
  for (TagId id = 0; id < 60; ++id) {
    EXPECT_EQ(decoder.decode(family->codeword(id) ^ 0x900a00811), (Match{id, 7, 0}));
  }
  EXPECT_EQ(decoder.decode(family->codeword(60)), std::nullopt);
  EXPECT_EQ(refusal_of(family, with(DecoderEngine::Auto, 7)),
            "7 bit errors are more than generated36 corrects safely; with its distance 8, at most "
            "3 are, unless an unsafe radius is allowed");
}

TEST(Decoder, ReadsEveryLevelOfBundledGeneratedFamiliesUpToItsSafeRadius) {
  std::mt19937_64 random(13);
  int levels_read = 0;
  for (const std::string& name : family_names()) {
    const SharedFamily family = find_family(name);
    if (family->is_listed()) continue;
    const int bits = family->bits();
    for (const Level& level : family->levels()) {
      DecoderOptions options;
      options.ids.resize(level.codes);
      std::iota(options.ids.begin(), options.ids.end(), 0);
      options.max_errors = (level.min_hamming - 1) / 2;
      const Decoder decoder(family, options);
      ASSERT_EQ(decoder.engine(), DecoderEngine::InformationSets) << name;
      ASSERT_LT(decoder.table_bytes(), std::size_t{64} << 20) << name;
      for (int i = 0; i < 200; ++i) {
        const auto id = static_cast<TagId>(random() % level.codes);
        const int errors = static_cast<int>(random() % (*options.max_errors + 1U));
        Codeword flips = 0;
        while (std::popcount(flips) < errors) flips |= Codeword{1} << random() % bits;
        const int turns = static_cast<int>(random() % 4);
        const Codeword observed = rotate(family->codeword(id) ^ flips, bits, 4 - turns);
        ASSERT_EQ(decoder.decode(observed), (Match{id, errors, turns}))
            << name << ", level of " << level.codes << ", " << to_hex(observed);
      }
      ++levels_read;
    }
  }
  EXPECT_GT(levels_read, 20);
}

TEST(Decoder, ListsAFewIdsOfALevelThatAreFartherApartThanTheLevel) {
  const auto family = std::make_shared<const Family>(test::generated_36());
  DecoderOptions options;
  for (TagId id = 70000; id < 130816 && options.ids.size() < 4; id += 7) {
    options.ids.push_back(id);
    if (distance_of_ids(*family, options.ids) < 14) options.ids.pop_back();
  }
  ASSERT_EQ(options.ids.size(), 4U);
  EXPECT_EQ(Decoder(family, options).engine(), DecoderEngine::InformationSets);
  options.max_errors = 6;
  const Decoder decoder(family, options);
  EXPECT_EQ(decoder.engine(), DecoderEngine::Chunks);
  for (const TagId id : options.ids) {
    EXPECT_EQ(decoder.decode(family->codeword(id) ^ 0x3f), (Match{id, 6, 0}));
  }
}

TEST(Decoder, AGeneratedFamilyTakesLittleMemory) {
  const auto family = std::make_shared<const Family>(test::generated_36());
  const Decoder decoder(family);
  EXPECT_EQ(decoder.engine(), DecoderEngine::InformationSets);
  EXPECT_EQ(decoder.max_errors(), 2);
  EXPECT_LT(decoder.table_bytes(), 1U << 20);
}

TEST(Decoder, ImpossibleOptionsAreNamed) {
  const SharedFamily family = find_family("tag36h11");
  EXPECT_NE(refusal_of(nullptr, {}).find("not null"), std::string::npos);
  EXPECT_EQ(refusal_of(family, with(DecoderEngine::Auto, -1)),
            "-1 bit errors cannot be corrected in tag36h11; 0 to 5 can");
  EXPECT_NE(refusal_of(family, with(DecoderEngine::Auto, 37, true)).find("0 to 36 can"),
            std::string::npos);
  EXPECT_EQ(refusal_of(family, with(DecoderEngine::Auto, 6)),
            "6 bit errors are more than tag36h11 corrects safely; with its distance 11, at most 5 "
            "are, unless an unsafe radius is allowed");
  EXPECT_EQ(refusal_of(family, with(DecoderEngine::Auto, 6, true)), "accepted");
  EXPECT_EQ(refusal_of(family, with(DecoderEngine::Hash, 3)),
            "the hash table corrects at most 2 bit errors, not 3; the chunk index corrects any");
  EXPECT_EQ(refusal_of(family, with(DecoderEngine::InformationSets, 2)),
            "tag36h11 lists its codewords; information sets decode families that have a generator");
  DecoderOptions options = with(DecoderEngine::Auto, 8);
  options.ids = {5, 40};
  EXPECT_EQ(refusal_of(family, options),
            "8 bit errors are more than tag36h11 corrects safely; with the chosen ids' distance "
            "15, at most 7 are, unless an unsafe radius is allowed");
  options.ids = {5, 587};
  EXPECT_EQ(refusal_of(family, options), "id 587 is not in tag36h11, which has ids 0 to 586");
}

}  // namespace
}  // namespace tagmint::codec
