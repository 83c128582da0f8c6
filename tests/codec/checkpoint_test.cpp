#include "tagmint/codec/search/checkpoint.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "search/engines.h"
#include "support/lexicode_options.h"
#include "support/scratch_folder.h"
#include "support/written_search.h"

namespace tagmint::codec {
namespace {

using tagmint::test::read_file;
using tagmint::test::ScratchFolder;
using tagmint::testing::expect_same;
using tagmint::testing::kEarlyTree;
using tagmint::testing::options_for;
using tagmint::testing::parameters_of;
using tagmint::testing::small_search;
using tagmint::testing::write_search;
using tagmint::testing::WrittenSearch;

TEST(Checkpoint, SearchGoesOnFromEveryPlaceToTheSameResult) {
  const LexicodeOptions options = small_search();
  const WrittenSearch written = write_search(options, 1);
  const LexicodeResult whole = search_plain(options);
  expect_same(written.result, whole, "undisturbed");
  const ScratchFolder folder;
  std::array<int, 4> seen{};
  for (std::size_t i = 0; i < written.places.size(); i += 1 + written.places.size() / 40) {
    const std::string path =
        folder.write("search", written.file.substr(0, written.places[i].bytes));
    Checkpoint checkpoint = Checkpoint::resume(path, parameters_of(options));
    LexicodeOptions rest = options;
    SearchState start = checkpoint.take_content().state;
    ++seen[static_cast<int>(start.phase)];
    rest.step = [&](const SearchStep& step) { checkpoint.add(step); };
    expect_same(search_by_tree(rest, kEarlyTree, std::move(start)), whole,
                fmt::format("record {}", i));
  }
  for (const SearchPhase phase : {SearchPhase::Walk, SearchPhase::List, SearchPhase::Choose}) {
    EXPECT_GT(seen[static_cast<int>(phase)], 0) << static_cast<int>(phase);
  }
}

TEST(Checkpoint, SearchThatIsStoppedAgainAndAgainEndsWithTheSameResult) {
  const LexicodeOptions options = small_search();
  const LexicodeResult whole = search_plain(options);
  const ScratchFolder folder;
  const std::string path = folder.file("search");
  std::optional<Checkpoint> checkpoint = Checkpoint::begin(path, parameters_of(options));
  LexicodeResult result;
  int stops = 0;
  for (;; ++stops) {
    LexicodeOptions rest = options;
    std::stop_source source;
    rest.stop = source.get_token();
    int steps = 0;
    rest.step = [&](const SearchStep& step) {
      checkpoint->add(step);
      if (++steps == 2) source.request_stop();
    };
    result = search_by_tree(rest, kEarlyTree, checkpoint->take_content().state);
    if (result.end != SearchEnd::Stopped) break;
    checkpoint.reset();
    checkpoint = Checkpoint::resume(path, parameters_of(options));
  }
  EXPECT_GT(stops, 5);
  expect_same(result, whole, "in pieces");
}

TEST(Checkpoint, CutOffFileGivesTheLastWholeRecord) {
  const LexicodeOptions options = small_search();
  const WrittenSearch written = write_search(options, 4);
  const std::size_t header = written.places.front().bytes;
  const ScratchFolder folder;
  for (std::size_t bytes = 0; bytes <= written.file.size(); ++bytes) {
    const std::string what = fmt::format("{} bytes", bytes);
    const std::string path = folder.write(what, written.file.substr(0, bytes));
    expect_same(Checkpoint::resume(path, parameters_of(options)).content().state,
                written.state_at(bytes), what);
    // What was cut off is gone, and a search that was killed while it began its file has one.
    EXPECT_GE(read_file(path).size(), header) << what;
    expect_same(Checkpoint::resume(path, parameters_of(options)).content().state,
                written.state_at(bytes), what + ", again");
  }
}

TEST(Checkpoint, SearchGoesOnBehindARecordThatWasCutOff) {
  const LexicodeOptions options = small_search();
  const WrittenSearch written = write_search(options, 4);
  const ScratchFolder folder;
  const std::string path = folder.write("search", written.file.substr(0, written.file.size() / 2));
  LexicodeOptions rest = options;
  {
    Checkpoint checkpoint = Checkpoint::resume(path, parameters_of(options));
    rest.step = [&](const SearchStep& step) { checkpoint.add(step); };
    search_by_tree(rest, kEarlyTree, checkpoint.take_content().state);
  }
  const CheckpointContent content = Checkpoint::resume(path, parameters_of(options)).take_content();
  EXPECT_EQ(content.state.codewords, written.result.codewords);
}

TEST(Checkpoint, AttemptsFollowEachOther) {
  const ScratchFolder folder;
  const std::string path = folder.file("search");
  const CheckpointParameters parameters = parameters_of(small_search(), 3);
  const std::vector<Codeword> first = {5, 6};
  const std::vector<Codeword> second = {7};
  {
    Checkpoint checkpoint = Checkpoint::begin(path, parameters);
    checkpoint.add({SearchPhase::Walk, 10, first});
    checkpoint.end_attempt({first, 10, SearchEnd::LimitWords});
    checkpoint.end_attempt({{}, 0, SearchEnd::Complete});
    checkpoint.add({SearchPhase::Walk, 3, second});
  }
  const CheckpointContent content = Checkpoint::resume(path, parameters).take_content();
  ASSERT_EQ(content.finished.size(), 2u);
  expect_same(content.finished[0], {first, 10, SearchEnd::LimitWords}, "first");
  expect_same(content.finished[1], {{}, 0, SearchEnd::Complete}, "second");
  SearchState running;
  running.apply({SearchPhase::Walk, 3, second});
  expect_same(content.state, running, "third");
}

/// One number for a list of words in any order.
Codeword sum_of(std::span<const Codeword> words) {
  return std::accumulate(words.begin(), words.end(), Codeword{0},
                         [](Codeword sum, Codeword word) { return sum + word * word; });
}

// A file says how many subtrees are listed. When this test fails, the format needs a new number
// (kFormatVersion), and then this test new figures.
TEST(Checkpoint, SubtreesAreThoseThatTheFormatMeans) {
  EXPECT_EQ(subtree_count(17), 2u);
  EXPECT_EQ(subtree_count(36), std::uint64_t{1} << 12);
  EXPECT_EQ(subtree_count(61), std::uint64_t{1} << 37);
  const auto crew = local_crew(rules_of(options_for("classic:10", 17, "seed:1", "none")), 1);
  const std::vector<Codeword> codes = {0x123456789, 0xabcdef012, 0x0f0f33355, 0x913579bdf};
  crew->learn(codes);
  EXPECT_EQ(sum_of(crew->list_open(1500, 2)), 4480220452094857622u);
  EXPECT_EQ(sum_of(crew->list_open(1000, 2)), 17961755310636009104u);
}

}  // namespace
}  // namespace tagmint::codec
