#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "search/engines.h"
#include "support/lexicode_options.h"
#include "support/scratch_folder.h"
#include "tagmint/codec/search/checkpoint.h"

namespace tagmint::testing {

/// Goes through all three phases at once, in many rounds.
inline constexpr codec::TreeSearchTuning kEarlyTree{
    .least_scanned = 50000, .words_per_open_tag = 0, .most_positions = 500};

inline codec::LexicodeOptions small_search() {
  return options_for("circle:9", 7, "apriltag3", "energy:0.3333");
}

inline codec::CheckpointParameters parameters_of(const codec::LexicodeOptions& options,
                                                 int attempts = 1) {
  return {rules_of(options), attempts};
}

inline void expect_same(const codec::SearchState& a, const codec::SearchState& b,
                        const std::string& what) {
  EXPECT_EQ(a.phase, b.phase) << what;
  EXPECT_EQ(a.words_walked, b.words_walked) << what;
  EXPECT_EQ(a.codewords, b.codewords) << what;
  EXPECT_EQ(a.walked_codes, b.walked_codes) << what;
  EXPECT_EQ(a.subtrees_listed, b.subtrees_listed) << what;
  EXPECT_EQ(a.open_tags, b.open_tags) << what;
  EXPECT_EQ(a.chosen_to, b.chosen_to) << what;
}

inline void expect_same(const codec::LexicodeResult& a, const codec::LexicodeResult& b,
                        const std::string& what) {
  EXPECT_EQ(a.codewords, b.codewords) << what;
  EXPECT_EQ(a.words_searched, b.words_searched) << what;
  EXPECT_EQ(a.end, b.end) << what;
}

/// A file that a search has written whole, with what it held after each record.
struct WrittenSearch {
  struct Place {
    std::size_t bytes = 0;
    codec::SearchState state;
  };
  std::string file;
  std::vector<Place> places;  // the first one right behind the header
  codec::LexicodeResult result;

  /// What a search can go on from when only so many bytes are left.
  const codec::SearchState& state_at(std::size_t bytes) const {
    std::size_t last = 0;
    while (last + 1 < places.size() && places[last + 1].bytes <= bytes) ++last;
    return places[last].state;
  }
};

/// Runs the search; `every` steps become one record where they can.
inline WrittenSearch write_search(codec::LexicodeOptions options, int every) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("search");
  codec::Checkpoint checkpoint = codec::Checkpoint::begin(path, parameters_of(options));
  WrittenSearch written;
  const auto note = [&](codec::SearchState state) {
    const std::size_t bytes = std::filesystem::file_size(path);
    written.places.push_back({bytes, std::move(state)});
  };
  note({});
  codec::SearchState state;
  int steps = 0;
  options.step = [&](const codec::SearchStep& step) {
    const bool same_phase = step.phase == state.phase;
    if (!same_phase) checkpoint.flush();
    if (!same_phase && steps > 0) note(state);
    checkpoint.add(step);
    state.apply(step);
    // A slow machine makes it write before it is asked to.
    const bool has_written = std::filesystem::file_size(path) != written.places.back().bytes;
    if (++steps % every != 0 && !has_written) return;
    checkpoint.flush();
    note(state);
  };
  written.result = codec::search_by_tree(options, kEarlyTree);
  checkpoint.flush();
  note(state);
  written.file = test::read_file(path);
  return written;
}

}  // namespace tagmint::testing
