#pragma once

#include <cstdint>

namespace tagmint::codec {

/// The pseudo-random sequence of java.util.Random, as its public documentation specifies it: a
/// linear congruential generator modulo 2^48 of which the upper 32 bits are given out. The
/// published families start their walks with it.
class JavaRandom {
 public:
  /// The state that java.util.Random(seed) starts from.
  explicit JavaRandom(std::int64_t seed)
      : state_((static_cast<std::uint64_t>(seed) ^ kMultiplier) & kMask) {}

  /// The next of all 2^32 possible values.
  std::int32_t next_int() {
    state_ = (state_ * kMultiplier + kIncrement) & kMask;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(state_ >> 16));
  }

  /// (next_int() << 32) + next_int(), both signed, modulo 2^64.
  std::int64_t next_long() {
    const auto high = static_cast<std::uint64_t>(next_int()) << 32;
    return static_cast<std::int64_t>(high + static_cast<std::uint64_t>(next_int()));
  }

 private:
  static constexpr std::uint64_t kMultiplier = 0x5DEECE66D;
  static constexpr std::uint64_t kIncrement = 0xB;
  static constexpr std::uint64_t kMask = (std::uint64_t{1} << 48) - 1;

  std::uint64_t state_;
};

}  // namespace tagmint::codec
