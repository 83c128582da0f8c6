#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "kernels/hamming_kernels.h"
#include "tagmint/codec/family.h"

/// Rotation distances over all pairs of a family's codewords, the part of statistics and proofs
/// that costs time. Pairs are (i, j) with i < j; the level of a pair is the first level that holds
/// j.
namespace tagmint::codec {

/// For each level the number of its pairs at each rotation distance.
///   levels   growing; the last is all codewords
///   threads  0 = all cores; the result does not depend on it
///   cost     O(codewords^2); about a nanosecond a pair and thread
std::vector<DistanceHistogram> pair_histograms(std::span<const Codeword> codewords, int bits,
                                               std::span<const Level> levels, int threads);

/// The pair nearer than its level's min_hamming that has the lowest i, and of those the lowest j.
std::optional<std::pair<TagId, TagId>> first_near_pair(std::span<const Codeword> codewords,
                                                       int bits, std::span<const Level> levels,
                                                       int threads);

}  // namespace tagmint::codec
