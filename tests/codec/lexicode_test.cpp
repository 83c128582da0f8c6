#include "tagmint/codec/search/lexicode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include "search/engines.h"
#include "support/lexicode_options.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

using tagmint::testing::options_for;

/// The definition, word by word.
LexicodeResult by_definition(const LexicodeOptions& options, std::uint64_t words) {
  const int bits = options.layout.bits();
  const Walk walk(
      options.layout, options.order,
      walk_seed(options.order, options.layout, options.min_hamming, options.complexity));
  const ComplexityJudge judge(options.layout, options.complexity);
  LexicodeResult result;
  for (std::uint64_t i = 1; i <= words; ++i) {
    const Codeword word = walk.at(i);
    const bool distant = std::all_of(
        result.codewords.begin(), result.codewords.end(),
        [&](Codeword code) { return rotation_distance(word, code, bits) >= options.min_hamming; });
    if (distant && self_distance(word, bits) >= options.min_hamming && judge.accepts(word)) {
      result.codewords.push_back(word);
    }
  }
  result.words_searched = words;
  return result;
}

TEST(Lexicode, IsWhatItsDefinitionSays) {
  for (const char* order : {"apriltag2", "apriltag3", "seed:7"}) {
    for (const char* complexity : {"none", "rectangles:5", "energy:0.3333"}) {
      for (const int min_hamming : {1, 4, 5, 8, 9}) {
        LexicodeOptions options = options_for("classic:8", min_hamming, order, complexity);
        options.limit_words = min_hamming == 1 ? 3000 : 1u << 16;
        EXPECT_EQ(search_lexicode(options).codewords,
                  by_definition(options, *options.limit_words).codewords)
            << order << ' ' << complexity << ' ' << min_hamming;
      }
    }
  }
}

TEST(Lexicode, DoesNotDependOnThreads) {
  LexicodeOptions options = options_for("circle:9", 5, "seed:1", "energy:0.3333");
  options.limit_words = 300000;
  options.threads = 1;
  const LexicodeResult expected = search_lexicode(options);
  EXPECT_EQ(expected.end, SearchEnd::LimitWords);
  for (const int threads : {2, 3, 8}) {
    options.threads = threads;
    EXPECT_EQ(search_lexicode(options).codewords, expected.codewords) << threads;
  }
}

TEST(Lexicode, LimitsGiveAPrefixOfTheWalk) {
  LexicodeOptions options = options_for("circle:9", 7, "apriltag3", "energy:0.3333");
  const LexicodeResult whole = search_lexicode(options);
  EXPECT_EQ(whole.end, SearchEnd::Complete);
  EXPECT_EQ(whole.words_searched, 1u << 21);
  ASSERT_GT(whole.codewords.size(), 20u);

  options.limit_codes = 20;
  const LexicodeResult codes = search_lexicode(options);
  EXPECT_EQ(codes.end, SearchEnd::LimitCodes);
  EXPECT_EQ(codes.codewords,
            std::vector<Codeword>(whole.codewords.begin(), whole.codewords.begin() + 20));
  const Walk walk(options.layout, options.order, 210710);
  EXPECT_EQ(codes.words_searched, walk.position_of(codes.codewords.back()));

  options.limit_codes.reset();
  options.limit_words = codes.words_searched;
  const LexicodeResult words = search_lexicode(options);
  EXPECT_EQ(words.end, SearchEnd::LimitWords);
  EXPECT_EQ(words.codewords, codes.codewords);
  options.limit_words = codes.words_searched - 1;
  EXPECT_EQ(search_lexicode(options).codewords.size(), 19u);
}

TEST(Lexicode, LimitsMayBeZeroOrBeyondTheEnd) {
  LexicodeOptions options = options_for("classic:8", 5, "apriltag2", "rectangles:5");
  options.limit_words = 0;
  EXPECT_EQ(search_lexicode(options).end, SearchEnd::LimitWords);
  EXPECT_EQ(search_lexicode(options).words_searched, 0u);
  options.limit_words = 1u << 20;
  EXPECT_EQ(search_lexicode(options).end, SearchEnd::Complete);
  EXPECT_EQ(search_lexicode(options).words_searched, 1u << 16);
  options.limit_codes = 0;
  EXPECT_EQ(search_lexicode(options).end, SearchEnd::LimitCodes);
  EXPECT_TRUE(search_lexicode(options).codewords.empty());
}

TEST(Lexicode, EndsEarlyWhenAskedTo) {
  LexicodeOptions options = options_for("standard:10", 13, "apriltag3", "energy:0.3333");
  std::stop_source source;
  options.stop = source.get_token();
  options.progress = [&](const SearchProgress& progress) {
    EXPECT_GT(progress.words_done, 0u);
    EXPECT_EQ(progress.words_total, 4503599627370496.0);
    source.request_stop();
  };
  const LexicodeResult stopped = search_lexicode(options);
  EXPECT_EQ(stopped.end, SearchEnd::Stopped);

  LexicodeOptions limited = options_for("standard:10", 13, "apriltag3", "energy:0.3333");
  limited.time_limit = std::chrono::milliseconds(50);
  const LexicodeResult late = search_lexicode(limited);
  EXPECT_EQ(late.end, SearchEnd::TimeLimit);
  EXPECT_GT(late.words_searched, 0u);

  // Whatever was found is the beginning of the one and only sequence.
  const std::size_t common = std::min(stopped.codewords.size(), late.codewords.size());
  ASSERT_GT(common, 0u);
  EXPECT_TRUE(std::equal(stopped.codewords.begin(), stopped.codewords.begin() + common,
                         late.codewords.begin()));
}

TEST(Lexicode, KeepsItsTimeWhereNearlyAllWordsAreTaken) {
  LexicodeOptions options = options_for("classic:10", 1, "seed:1", "none");
  options.time_limit = std::chrono::milliseconds(300);
  // A round too many takes seconds; rounds that went on doubling would take hours.
  EXPECT_EQ(search_lexicode(options).end, SearchEnd::TimeLimit);
}

TEST(Lexicode, RefusesImpossibleDistances) {
  for (const int min_hamming : {-1, 0, 17}) {
    EXPECT_THROW(search_lexicode(options_for("classic:8", min_hamming, "apriltag2", "none")),
                 std::invalid_argument);
  }
}

TEST(Lexicode, FamilyTellsHowItWasMade) {
  LexicodeOptions options = options_for("circle:9", 7, "apriltag3", "energy:0.3333");
  options.limit_words = 1000;
  const LexicodeResult result = search_lexicode(options);
  const Family family = make_family(options, result);
  EXPECT_EQ(family.name(), "tagCircle21h7");
  EXPECT_EQ(family.min_hamming(), 7);
  EXPECT_EQ(family.complexity(), options.complexity);
  EXPECT_TRUE(std::equal(family.codewords().begin(), family.codewords().end(),
                         result.codewords.begin(), result.codewords.end()));
  EXPECT_EQ(family.origin().method, "lexicode");
  EXPECT_EQ(family.origin().order, "apriltag3");
  EXPECT_EQ(family.origin().seed, "210710");
  EXPECT_EQ(family.origin().searched, "the first 1000 words of the walk (0.04768 %)");
  EXPECT_EQ(family.origin().program.substr(0, 8), "tagmint ");
  EXPECT_EQ(make_family(options, result, "mine").name(), "mine");

  options.limit_words.reset();
  EXPECT_EQ(make_family(options, search_lexicode(options)).origin().searched, "complete");
  EXPECT_THROW(make_family(options, {}), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::codec
