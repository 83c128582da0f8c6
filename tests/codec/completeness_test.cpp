#include "tagmint/codec/search/completeness.h"

#include <gtest/gtest.h>

#include <stop_token>
#include <vector>

#include "support/addable_word.h"
#include "support/lexicode_options.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::codec {
namespace {

using tagmint::testing::could_be_added;
using tagmint::testing::options_for;
using tagmint::testing::without;

Family searched(const char* layout, int min_hamming, const char* order, const char* complexity) {
  const LexicodeOptions options = options_for(layout, min_hamming, order, complexity);
  return make_family(options, search_lexicode(options));
}

/// Whether any word could be added, by looking at each.
bool complete_by_definition(const Family& family) {
  for (Codeword word = 0; word <= low_mask(family.bits()); ++word) {
    if (could_be_added(family, word)) return false;
  }
  return true;
}

TEST(Completeness, FinishedSearchesAreComplete) {
  for (const Family& family :
       {searched("classic:7", 3, "seed:1", "none"),  // 9 bits: no tree
        searched("classic:8", 4, "seed:1", "none"), searched("classic:8", 8, "seed:2", "none"),
        searched("classic:8", 5, "apriltag2", "rectangles:5"),
        searched("classic:8", 5, "seed:3", "energy:0.4")}) {
    EXPECT_TRUE(complete_by_definition(family)) << family.name();
    const Completeness proven = prove_complete(family);
    EXPECT_FALSE(proven.stopped);
    EXPECT_EQ(proven.addable, std::nullopt) << family.name();
  }
  EXPECT_EQ(prove_complete(*find_family("tagCircle21h7")).addable, std::nullopt);
}

TEST(Completeness, FamilyThatLacksATagIsNot) {
  for (const Family& whole :
       {searched("classic:7", 3, "seed:1", "none"), searched("classic:8", 4, "seed:1", "none"),
        searched("classic:8", 5, "apriltag2", "rectangles:5"),
        searched("circle:9", 8, "seed:3", "energy:0.4")}) {
    for (TagId id = 0; id < whole.size(); id += 1 + whole.size() / 5) {
      const Family family = without(whole, id);
      const Completeness proven = prove_complete(family);
      ASSERT_TRUE(proven.addable) << family.name() << " without " << id;
      EXPECT_TRUE(could_be_added(family, *proven.addable)) << family.name() << " without " << id;
    }
  }
}

TEST(Completeness, WordDoesNotDependOnThreads) {
  for (const char* name : {"tag16h5", "tagCircle21h7"}) {
    const Family family = without(*find_family(name), 7);
    const auto expected = prove_complete(family, {.threads = 1}).addable;
    ASSERT_TRUE(expected);
    for (const int threads : {2, 3, 8}) {
      EXPECT_EQ(prove_complete(family, {.threads = threads}).addable, expected) << threads;
    }
  }
}

TEST(Completeness, OpenWordsWithoutNumberAreNoHindrance) {
  // 64 bits have no tree; of 52 nearly all words are open.
  for (const char* layout : {"classic:12", "standard:10"}) {
    const LexicodeOptions begun = [&] {
      LexicodeOptions options = options_for(layout, 9, "seed:1", "energy:0.3");
      options.limit_codes = 2;
      return options;
    }();
    const Family family = make_family(begun, search_lexicode(begun));
    const Completeness proven = prove_complete(family);
    ASSERT_TRUE(proven.addable) << layout;
    EXPECT_TRUE(could_be_added(family, *proven.addable)) << layout;
  }
}

TEST(Completeness, StopsWhenAskedAndTellsHowFarItIs) {
  std::stop_source source;
  double last = 0;
  const CompletenessOptions options{.stop = source.get_token(),
                                    .progress = [&](double done, double total) {
                                      EXPECT_GT(done, last);
                                      EXPECT_EQ(total, 0x1p36);
                                      last = done;
                                      source.request_stop();
                                    }};
  const Completeness proven = prove_complete(*find_family("tag36h11"), options);
  EXPECT_TRUE(proven.stopped);
  EXPECT_EQ(proven.addable, std::nullopt);
  EXPECT_GT(last, 0);
  EXPECT_LT(last, 0x1p36);
}

}  // namespace
}  // namespace tagmint::codec
