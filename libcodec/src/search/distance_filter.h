#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "search/turn_blocks.h"
#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// Finds the words that are at least `min_hamming` from every word in `blocks`. A block that
/// excludes a word changes places with the one half as far from the front: blocks that exclude many
/// words drift there, and most words are excluded after a few comparisons.
///   words    at most 2^32
///   blocks   accepted codes; their order changes, the result does not depend on it
///   kept     room for words.size() indices
///   returns  number of indices written to `kept`, ascending
///   cost     O(words * blocks) at worst
std::size_t keep_distant(std::span<const Codeword> words, TurnBlocks& blocks, int min_hamming,
                         std::uint32_t* kept);

/// The plain loop that keep_distant() is tested against.
std::size_t keep_distant_scalar(std::span<const Codeword> words, TurnBlocks& blocks,
                                int min_hamming, std::uint32_t* kept);

}  // namespace tagmint::codec
