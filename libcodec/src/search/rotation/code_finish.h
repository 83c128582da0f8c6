#pragma once

#include "search/rotation/chain_search.h"
#include "tagmint/codec/search/rotation_codes.h"

namespace tagmint::codec {

/// A family from a chain: cells and translation chosen, levels told with their true distances
/// (levels that share one with the next are left out), plain tags counted; listed when it has at
/// most kMostListedTags tags.
FamilyParts finish_chain(const CodeChain& chain, const RotationCodeOptions& options,
                         RandomChoice& random);

/// A listed family of one level from a union of cosets: one word of each tag.
FamilyParts finish_union(const std::vector<Codeword>& tags, const RotationCodeOptions& options,
                         RandomChoice& random);

/// Adds to a listed family what the lexicode search still finds at the distance asked for: to the
/// last level, or as a new level where that distance is smaller than the last level's and the new
/// tags are at least an eighth of the old ones. Returns how many were added.
///   errors   none; a stopped search adds nothing
std::size_t fill_up(FamilyParts& family, const RotationCodeOptions& options);

}  // namespace tagmint::codec
