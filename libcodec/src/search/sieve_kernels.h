#pragma once

#include <cstddef>
#include <cstdint>

namespace tagmint::codec::sieve_kernels {

/// Elements that the functions below may read and write behind the end of an array: the lanes of
/// the widest vector in use.
inline constexpr std::size_t kPadding = 16;

/// Writes first, first + step, first + 2 step, ... modulo 2^bits; bits in 1..32.
///   out   room for count + kPadding
void fill_progression(std::uint32_t first, std::uint32_t step, int bits, std::size_t count,
                      std::uint32_t* out);
void fill_progression_scalar(std::uint32_t first, std::uint32_t step, int bits, std::size_t count,
                             std::uint32_t* out);

/// Keeps, in their order, the words that are at least `min_hamming` from every code.
///   words     changed in place; room for count + kPadding
///   returns   number of words kept
///   cost      O(count * codes) at worst; words that are excluded early cost less
std::size_t keep_far(std::uint32_t* words, std::size_t count, const std::uint32_t* codes,
                     std::size_t code_count, int min_hamming);
std::size_t keep_far(std::uint64_t* words, std::size_t count, const std::uint64_t* codes,
                     std::size_t code_count, int min_hamming);
std::size_t keep_far_scalar(std::uint32_t* words, std::size_t count, const std::uint32_t* codes,
                            std::size_t code_count, int min_hamming);
std::size_t keep_far_scalar(std::uint64_t* words, std::size_t count, const std::uint64_t* codes,
                            std::size_t code_count, int min_hamming);

/// Copies the codes of the cells key ^ masks[0], key ^ masks[1], ... behind each other.
///   starts    cell c holds codes starts[c] .. starts[c + 1] - 1
///   codes     padded
///   out       room for all these codes and kPadding
///   returns   number of codes copied
std::size_t gather_cells(const std::uint32_t* starts, const std::uint32_t* codes, std::uint32_t key,
                         const std::uint32_t* masks, std::size_t mask_count, std::uint32_t* out);
std::size_t gather_cells_scalar(const std::uint32_t* starts, const std::uint32_t* codes,
                                std::uint32_t key, const std::uint32_t* masks,
                                std::size_t mask_count, std::uint32_t* out);

}  // namespace tagmint::codec::sieve_kernels
