#pragma once

#include <cstddef>

#include "search/search_run.h"

namespace tagmint::codec {

/// How phase 2 ended.
enum class ListingEnd {
  Done,
  TooMany,   ///< more tags are open than may be held
  TooSlow,   ///< would not be done within the time limit
  MustStop,  ///< SearchControl::must_end()
};

/// Part of the words behind phase 1 that are reported as done when the listing is done; the choice
/// among the open words takes the rest.
inline constexpr double kListingShareOfProgress = 0.9;

/// Phase 2: lists the tags that the codes of phase 1 leave open, over the whole space, not along
/// the walk; goes on where the state of the run is.
///   most           give up when more tags than this are open
///   may_give_up    a listing that cannot be done within the time limit is given up when that is
///                  seen; else it goes on until the limit, for another run to go on from there
///   cost           2^bits / 2^14 leaves of OpenWordTree, divided among the crew
///   memory         8 bytes for each open tag
ListingEnd list_open_tags(SearchRun& run, std::size_t most, bool may_give_up);

}  // namespace tagmint::codec
