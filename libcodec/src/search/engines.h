#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "tagmint/codec/search/lexicode.h"

namespace tagmint::codec {

/// search_lexicode() by comparing every word of the walk with the codes: the reference.
LexicodeResult search_plain(const LexicodeOptions& options, SearchState start = {});

/// The same with words sifted in groups (WalkSieve): for walks that the tree does not pay for.
LexicodeResult search_by_walk(const LexicodeOptions& options, SearchState start = {});

/// What search_by_tree() may be told; matters of speed and memory, never of the result.
struct TreeSearchTuning {
  /// Visit at least this many words of the walk before the tree is tried.
  std::uint64_t least_scanned = 1u << 20;
  /// Words of the walk that are visited in the time that one open tag costs later.
  double words_per_open_tag = 500;
  /// Most open tags that are held; 8 bytes each. While more are expected the walk goes on.
  std::size_t most_open = std::size_t{1} << 26;
  /// Words that phase 3 holds at a time; 8 bytes each.
  std::size_t most_positions = std::size_t{1} << 24;
};

/// Whether search_by_tree() can serve a layout of that many bits.
bool tree_search_possible(int bits);

/// search_lexicode() in three phases (docs/lexicodes.md): the beginning of the walk word by word,
/// then a list of all words of the rest that may still become codes, then the greedy choice among
/// these. The same result as search_plain(), thousands of times faster where words are many; a
/// search that is ended early may have gone less far.
LexicodeResult search_by_tree(const LexicodeOptions& options, const TreeSearchTuning& tuning = {},
                              SearchState start = {});

}  // namespace tagmint::codec
