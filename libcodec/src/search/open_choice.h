#pragma once

#include <cstddef>

#include "search/search_run.h"

namespace tagmint::codec {

/// Phase 3: the greedy choice among the open tags of phase 2, all turns of each, in the order of
/// the walk; goes on where the state of the run is.
///   most_positions   about how many words are held at a time
///   cost             the open tags once against the codes that phase 3 finds, and little more
///   memory           8 bytes for each open tag, and for each of `most_positions`
LexicodeResult choose_among_open(SearchRun& run, std::size_t most_positions);

}  // namespace tagmint::codec
