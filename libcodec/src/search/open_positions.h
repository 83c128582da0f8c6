#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/search/order.h"

namespace tagmint::codec {

class SearchControl;

/// What list_open_positions() is to look for.
struct OpenPositionsRequest {
  const Walk& walk;
  std::span<const Codeword> codewords;  ///< the codes that exclude words
  int min_hamming = 0;
  std::uint64_t after = 0;  ///< walk positions up to this one are done
  std::uint64_t last = 0;   ///< index of the last word wanted: position last + 1
  std::size_t most = 0;     ///< give up when more tags than this are open
  int threads = 1;
  std::optional<int> paint_radius;  ///< OpenWordTree; nothing = the one that looks fastest
};

struct OpenPositions {
  enum class End {
    Done,
    TooMany,      ///< more than `most` tags are open
    TooSlow,      ///< would not be done within the time limit
    Interrupted,  ///< SearchControl::must_end()
  };
  End end = End::Done;
  /// Done only: ascending walk positions of all words that lie far enough from all turns of all
  /// codewords and from their own turns. Nothing else in the walk can become a code.
  std::vector<std::uint64_t> positions;
};

/// Part of the words behind `after` that are reported as done when the listing is done; the choice
/// among the open words takes the rest.
inline constexpr double kListingShareOfProgress = 0.9;

/// Goes through the whole space as a tree, not along the walk.
///   control  is told the progress, as if the walk went on, and asked whether to end
///   cost     2^bits / 2^14 leaves of OpenWordTree, divided among the threads
///   memory   8 bytes for an open tag, then 32 bytes for its four turns; the trees' lists
OpenPositions list_open_positions(const OpenPositionsRequest& request, SearchControl& control);

}  // namespace tagmint::codec
