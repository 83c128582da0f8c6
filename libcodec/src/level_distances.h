#pragma once

#include <cstddef>
#include <vector>

#include "kernels/hamming_kernels.h"
#include "tagmint/codec/tag_index.h"

/// Distances within the levels of a rotation code, without comparing all pairs: seen from each word
/// of a coset, the words of the code are equally far away, since sums of the basis cancel.
namespace tagmint::codec {

/// [d] = number of the level's words at distance d from the first word of a coset, added up over
/// the cosets of the level. Divided by the cosets it is what a word sees on average; with one
/// coset, what each word sees.
///   threads   0 = all cores; the result does not depend on it
///   cost      O(cosets * words), a quarter of it where turns exchange cosets; some 5 ns a word of
///   a
///             level of one coset
DistanceHistogram level_distances(const RotationCode& code, std::size_t level, int threads);

/// Smallest distance between two different words of the level that are turns of tags: of two tags
/// or of one.
///   distances   level_distances() of the level
int tag_distance(const TagIndex& index, std::size_t level, const DistanceHistogram& distances,
                 int threads);

/// One tag or two of a level, ascending, that have turns nearer than `min_hamming` to each other;
/// empty when there are none.
std::vector<TagId> near_tags(const TagIndex& index, std::size_t level, int min_hamming);

}  // namespace tagmint::codec
