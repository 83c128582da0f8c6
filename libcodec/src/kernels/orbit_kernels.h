#pragma once

#include <array>
#include <cstdint>

#include "colour_changes.h"

/// The inner loop of TagIndex: which of 64 words of a rotation code stand for their orbits, and
/// which of those have enough colour changes. It comes twice: a scalar reference, and a version
/// written with Highway and chosen at run time. Both give the same answers.
namespace tagmint::codec {

/// What the low six bits of an address add to its turns and colour changes: everything is linear,
/// so a word's share and that of the rest of its address are XORed.
struct LowAddresses {
  /// turned[t][low]: the low bits turned t + 1 times.
  alignas(64) std::array<std::array<std::uint32_t, 64>, 3> turned{};
  std::array<ChangeBits, 64> changes{};
};

/// The rest of 64 addresses, which have the low bits 0 to 63 each once. Addresses are below 2^31.
struct HighAddress {
  std::uint32_t address = 0;
  std::array<std::uint32_t, 3> turned{};  ///< the address turned once, twice, three times
  ChangeBits changes{};                   ///< the colour changes of the word there
};

/// Bit i of the result: the address with low bits i is smaller than its three turns.
std::uint64_t smallest_of_orbit(const LowAddresses& low, const HighAddress& high);

/// Those of `chosen` addresses whose words have at least `least` change bits.
std::uint64_t with_changes(std::uint64_t chosen, const LowAddresses& low, const HighAddress& high,
                           int least);

namespace scalar {
std::uint64_t smallest_of_orbit(const LowAddresses& low, const HighAddress& high);
std::uint64_t with_changes(std::uint64_t chosen, const LowAddresses& low, const HighAddress& high,
                           int least);
}  // namespace scalar

}  // namespace tagmint::codec
