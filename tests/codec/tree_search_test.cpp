#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include "search/engines.h"
#include "search/local_crew.h"
#include "search/tree_order.h"
#include "support/lexicode_options.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

using tagmint::testing::options_for;

TEST(TreeOrder, RoundTripsAndKeepsOneTurnOfFour) {
  for (const int bits : {16, 17, 20, 21}) {
    const TreeOrder order(bits);
    const auto stands_for_its_tag = [&](Codeword tree_word) {
      TreeOrder::Ties ties;
      for (int orbit = bits / 4 - 1; orbit >= 0; --orbit) {
        const unsigned nibble = tree_word >> (4 * orbit) & 0xf;
        if (TreeOrder::breaks_order(ties, nibble)) return false;
        ties = TreeOrder::after(ties, nibble);
      }
      return true;
    };
    std::size_t representatives = 0;
    for (Codeword word = 0; word < Codeword{1} << bits; word += 13) {
      EXPECT_EQ(order.to_codeword(order.to_tree(word)), word);
      int standing = 0;
      for (int turn = 0; turn < 4; ++turn) {
        standing += stands_for_its_tag(order.to_tree(rotate(word, bits, turn)));
      }
      EXPECT_GE(standing, 1) << bits << ' ' << word;
      representatives += standing == 1;
    }
    EXPECT_GT(representatives, (std::size_t{1} << bits) / 13 * 8 / 10) << bits;
  }
}

/// Positions of all words far enough from all turns of the codes and from their own, by looking at
/// each.
std::vector<std::uint64_t> open_by_definition(const Walk& walk, const std::vector<Codeword>& codes,
                                              int min_hamming, std::uint64_t after) {
  std::vector<std::uint64_t> open;
  for (std::uint64_t i = after + 1; i <= std::uint64_t{1} << walk.bits(); ++i) {
    const Codeword word = walk.at(i);
    if (self_distance(word, walk.bits()) >= min_hamming &&
        std::all_of(codes.begin(), codes.end(), [&](Codeword code) {
          return rotation_distance(word, code, walk.bits()) >= min_hamming;
        })) {
      open.push_back(i);
    }
  }
  return open;
}

/// Ascending walk positions of all turns of the tags.
std::vector<std::uint64_t> positions_of(const std::vector<Codeword>& tags, const Walk& walk,
                                        std::uint64_t after) {
  std::vector<std::uint64_t> positions;
  for (const Codeword tag : tags) {
    for (int turn = 0; turn < 4; ++turn) {
      const std::uint64_t position = walk.position_of(rotate(tag, walk.bits(), turn));
      if (position > after) positions.push_back(position);
    }
  }
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  return positions;
}

TEST(LocalCrew, ListsAllWordsThatNoCodeExcludes) {
  struct Case {
    const char* layout;
    int min_hamming;
  };
  for (const auto& [layout, min_hamming] :
       {Case{"classic:8", 2}, Case{"classic:8", 4}, Case{"classic:8", 5}, Case{"classic:8", 8},
        Case{"circle:9", 9}}) {
    LexicodeOptions options = options_for(layout, min_hamming, "seed:3", "none");
    options.limit_words = 1000;
    const LexicodeResult begun = search_plain(options);
    const Walk walk(options.layout, options.order, 3);
    const auto expected = open_by_definition(walk, begun.codewords, min_hamming, 1000);
    for (int paint_radius = 0; paint_radius < min_hamming; ++paint_radius) {
      LocalCrew crew(rules_of(options), 2, {.paint_radius = paint_radius});
      crew.learn(begun.codewords);
      const auto open = crew.list_open(0, subtree_count(walk.bits()));
      EXPECT_EQ(positions_of(open, walk, 1000), expected)
          << layout << " distance " << min_hamming << ", painted from " << paint_radius;
    }
  }
}

void expect_same(const LexicodeResult& tree, const LexicodeResult& plain, const std::string& what) {
  EXPECT_EQ(tree.codewords, plain.codewords) << what;
  EXPECT_EQ(tree.words_searched, plain.words_searched) << what;
  EXPECT_EQ(tree.end, plain.end) << what;
}

TEST(TreeSearch, FindsWhatThePlainSearchFinds) {
  struct Case {
    const char* layout;
    int min_hamming;
    const char* order;
    const char* complexity;
  };
  for (const Case& c :
       {Case{"classic:8", 3, "seed:1", "none"}, Case{"classic:8", 5, "apriltag2", "rectangles:5"},
        Case{"classic:8", 12, "apriltag3", "energy:0.3333"},
        Case{"circle:9", 6, "seed:-4", "rectangles:4"},
        Case{"circle:9", 7, "apriltag3", "energy:0.3333"}, Case{"circle:9", 8, "apriltag2", "none"},
        Case{"circle:9", 13, "seed:0", "none"}}) {
    const LexicodeOptions options = options_for(c.layout, c.min_hamming, c.order, c.complexity);
    const LexicodeResult plain = search_plain(options);
    for (const std::uint64_t least_scanned : {1u, 5000u}) {
      const TreeSearchTuning tuning{.least_scanned = least_scanned, .words_per_open_tag = 0};
      expect_same(search_by_tree(options, tuning), plain,
                  std::string(c.layout) + ' ' + std::to_string(c.min_hamming));
    }
  }
}

TEST(TreeSearch, LimitsGiveTheSamePrefixAsInThePlainSearch) {
  const LexicodeOptions whole = options_for("circle:9", 6, "seed:2", "energy:0.3333");
  const TreeSearchTuning tuning{.least_scanned = 1, .words_per_open_tag = 0};
  const std::size_t all = search_plain(whole).codewords.size();
  for (const std::size_t codes : {std::size_t{1}, all / 2, all - 1, all, all + 1}) {
    LexicodeOptions options = whole;
    options.limit_codes = codes;
    expect_same(search_by_tree(options, tuning), search_plain(options), std::to_string(codes));
  }
  for (const std::uint64_t words : {1u, 100000u, (1u << 21) - 1, 1u << 21}) {
    LexicodeOptions options = whole;
    options.limit_words = words;
    expect_same(search_by_tree(options, tuning), search_plain(options), std::to_string(words));
  }
}

TEST(TreeSearch, WalksOnWhileTooManyWordsAreOpen) {
  const LexicodeOptions options = options_for("circle:9", 7, "apriltag3", "energy:0.3333");
  const TreeSearchTuning tuning{.least_scanned = 1, .words_per_open_tag = 0, .most_open = 400};
  expect_same(search_by_tree(options, tuning), search_plain(options), "few may be open");
}

TEST(TreeSearch, ChoosesStretchByStretchOfTheWalk) {
  const LexicodeOptions options = options_for("circle:9", 6, "apriltag3", "energy:0.3333");
  const TreeSearchTuning tuning{
      .least_scanned = 1, .words_per_open_tag = 0, .most_positions = 1000};
  expect_same(search_by_tree(options, tuning), search_plain(options), "few are held at a time");
}

/// Where a search stands after each of its rounds.
std::vector<SearchState> states_of(LexicodeOptions options, const TreeSearchTuning& tuning) {
  std::vector<SearchState> states(1);
  options.step = [&](const SearchStep& step) {
    SearchState state = states.back();
    state.apply(step);
    states.push_back(state);
  };
  search_by_tree(options, tuning);
  return states;
}

TEST(TreeSearch, GoesOnFromWhereverItWas) {
  LexicodeOptions options = options_for("circle:9", 6, "apriltag2", "energy:0.3333");
  const TreeSearchTuning tuning{
      .least_scanned = 2000, .words_per_open_tag = 0, .most_positions = 10000};
  const LexicodeResult whole = search_plain(options);
  const std::vector<SearchState> states = states_of(options, tuning);
  std::array<int, 4> seen{};
  for (std::size_t i = 0; i < states.size(); i += 1 + states.size() / 50) {
    ++seen[static_cast<int>(states[i].phase)];
    expect_same(search_by_tree(options, tuning, states[i]), whole, "round " + std::to_string(i));
  }
  EXPECT_GT(seen[static_cast<int>(SearchPhase::Walk)], 0);
  EXPECT_GT(seen[static_cast<int>(SearchPhase::List)], 0);
  EXPECT_GT(seen[static_cast<int>(SearchPhase::Choose)], 0);
}

TEST(WalkSearch, FindsWhatThePlainSearchFinds) {
  for (const auto& [layout, min_hamming] : {std::pair{"circle:9", 5}, std::pair{"circle:9", 4}}) {
    LexicodeOptions options = options_for(layout, min_hamming, "apriltag2", "rectangles:4");
    const LexicodeResult plain = search_plain(options);
    EXPECT_GT(plain.codewords.size(), 100u) << "too few for groups";
    expect_same(search_by_walk(options), plain, layout);
    options.limit_codes = plain.codewords.size() * 2 / 3;
    expect_same(search_by_walk(options), search_plain(options), "limit");
  }
}

TEST(TreeSearch, RefusesLimitsThatItHasPassed) {
  LexicodeOptions options = options_for("circle:9", 6, "seed:1", "none");
  const SearchState start{.words_walked = 100, .codewords = {1, 2, 3}, .walked_codes = 3};
  options.limit_words = 99;
  EXPECT_THROW(search_lexicode(options, start), std::invalid_argument);
  options.limit_words.reset();
  options.limit_codes = 2;
  EXPECT_THROW(search_lexicode(options, start), std::invalid_argument);
}

TEST(TreeSearch, EndsEarlyWhenAskedTo) {
  // 2^52 words: the walk's beginning is quick, the tree would take days.
  LexicodeOptions options = options_for("standard:10", 20, "apriltag3", "none");
  const TreeSearchTuning tuning{
      .least_scanned = 1, .words_per_open_tag = 0, .most_open = std::size_t{1} << 62};
  options.time_limit = std::chrono::milliseconds(200);
  const LexicodeResult late = search_by_tree(options, tuning);
  EXPECT_EQ(late.end, SearchEnd::TimeLimit);

  options.time_limit.reset();
  std::stop_source source;
  options.stop = source.get_token();
  options.progress = [&](const SearchProgress&) { source.request_stop(); };
  const LexicodeResult stopped = search_by_tree(options, tuning);
  EXPECT_EQ(stopped.end, SearchEnd::Stopped);

  for (const LexicodeResult* result : {&late, &stopped}) {
    LexicodeOptions prefix = options_for("standard:10", 20, "apriltag3", "none");
    prefix.limit_words = std::min<std::uint64_t>(result->words_searched, 100000);
    const LexicodeResult plain = search_plain(prefix);
    EXPECT_TRUE(
        std::equal(plain.codewords.begin(), plain.codewords.end(), result->codewords.begin()));
  }
}

}  // namespace
}  // namespace tagmint::codec
