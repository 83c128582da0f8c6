#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/complexity.h"
#include "tagmint/codec/layout.h"

namespace tagmint::codec {

/// The order in which the lexicode search visits all words of a layout.
struct Order {
  enum class Kind {
    AprilTag2,  ///< words row by row, seeded as the classic families were
    AprilTag3,  ///< words in codeword order, seeded as the AprilTag 3 families were
    Seed,       ///< words in codeword order, own seed
  };
  Kind kind = Kind::AprilTag3;
  std::int64_t seed = 0;  ///< Kind::Seed only
  friend bool operator==(const Order&, const Order&) = default;
};

/// "apriltag2", "apriltag3" or "seed:N". Throws std::invalid_argument with a suggestion.
Order parse_order(std::string_view text);
std::string to_string(const Order& order);

/// Seed of java.util.Random that gives the walk's first word: nbits * 10000 + min_hamming * 100 +
/// c. In AprilTag2's families c was the rectangle threshold; in AprilTag3's five published ones it
/// was floor(width^2 / 8).
std::int64_t walk_seed(const Order& order, const Layout& layout, int min_hamming,
                       const Complexity& complexity);

/// The walk v_i = v_(i-1) + 982451653 (mod 2^bits), i = 1 .. 2^bits, v_0 = first nextLong() of the
/// seed (generation.md). Every word comes exactly once, v_0 itself last. Words at positions 1, 2,
/// ... are given in codeword order, whatever order the walk itself runs in.
class Walk {
 public:
  Walk(const Layout& layout, const Order& order, std::int64_t seed);

  int bits() const { return bits_; }
  /// Codeword at position i (any i; taken modulo 2^bits).
  Codeword at(std::uint64_t i) const;
  /// Position in 1 .. 2^bits of a codeword (for 64 bits, position 2^64 is returned as 0).
  std::uint64_t position_of(Codeword word) const;

 private:
  Codeword to_codeword(Codeword visited) const;
  Codeword to_visited(Codeword word) const;

  int bits_;
  Codeword start_;
  std::vector<int> visited_bit_;  // of codeword bit i (0 = least significant); empty = the same
};

}  // namespace tagmint::codec
