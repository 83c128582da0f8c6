#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tagmint/codec/export.h"
#include "tagmint/codec/family.h"

namespace tagmint::codec {

/// Up to so many ids distance_of_ids() compares each with each.
inline constexpr std::size_t kMostComparedIds = 8192;

/// The ids in ascending order, each once. Cost: O(ids) where they are so already.
TAGMINT_API std::vector<TagId> ascending_ids(std::vector<TagId> ids);

/// The Hamming distance of a few tags of a family, which may be larger than that of the whole
/// family: over all pairs, in every rotation, and between each tag and its own turns.
///   ids       in any order, some perhaps twice; empty = all
///   threads   0 = all cores; the result does not depend on it
///   returns   of the ids of a level (a prefix of all ids that the family declares a distance for)
///             what is declared; of other lists of up to kMostComparedIds what the codewords say;
///             of longer ones what is declared of the smallest level that holds them
/// Throws std::invalid_argument for an id that the family lacks.
///   cost      O(ids^2) word comparisons where it compares: 0.05 s for 8,192 ids on one thread
TAGMINT_API int distance_of_ids(const Family& family, std::span<const TagId> ids, int threads = 0);

/// Index in family.levels() of the smallest level that has all ids up to `last_id`, which is below
/// family.size().
TAGMINT_API std::size_t level_of_id(const Family& family, TagId last_id);

}  // namespace tagmint::codec
