#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/complexity.h"
#include "tagmint/codec/export.h"
#include "tagmint/codec/layout.h"
#include "tagmint/codec/search/bit_permutation.h"

namespace tagmint::codec {

/// The order in which the lexicode search visits all words of a layout.
struct TAGMINT_API Order {
  enum class Kind {
    AprilTag2,  ///< words row by row, seeded as the classic families were
    AprilTag3,  ///< words in codeword order, seeded as the AprilTag 3 families were
    Seed,       ///< words in codeword order, own seed
  };
  Kind kind = Kind::AprilTag3;
  std::int64_t seed = 0;  ///< Kind::Seed only
  friend bool operator==(const Order&, const Order&) = default;
};

/// "apriltag2", "apriltag3" or "seed:N" with a whole 64-bit N. Throws std::invalid_argument with a
/// suggestion.
TAGMINT_API Order parse_order(std::string_view text);
TAGMINT_API std::string to_string(const Order& order);

/// Seed of java.util.Random that gives the walk's first word: nbits * 10000 + min_hamming * 100 +
/// c. In AprilTag 2's families c was the rectangle threshold (taken as 0 under another rule); in
/// AprilTag 3's five published ones it was floor(width^2 / 8). Kind::Seed gives its own seed.
TAGMINT_API std::int64_t walk_seed(const Order& order, const Layout& layout, int min_hamming,
                                   const Complexity& complexity);

/// The walk v_i = v_(i-1) + 982451653 (mod 2^bits), i = 1 .. 2^bits, v_0 = first nextLong() of the
/// seed (docs/lexicodes.md). Every word comes exactly once, v_0 itself last.
///
/// The walk runs over *visited* words, whose bits are in reading order for AprilTag2 and in
/// codeword order otherwise. Distances are the same in both.
class TAGMINT_API Walk {
 public:
  Walk(const Layout& layout, const Order& order, std::int64_t seed);

  int bits() const { return bits_; }

  /// Codeword at position i (any i; taken modulo 2^bits).
  Codeword at(std::uint64_t i) const { return to_codeword(visited(i)); }
  /// Position in 1 .. 2^bits of a codeword (for 64 bits, position 2^64 is returned as 0).
  std::uint64_t position_of(Codeword word) const;

  /// Word at position i with its bits as the walk has them.
  Codeword visited(std::uint64_t i) const { return (start_ + i * kStep) & low_mask(bits_); }
  Codeword to_codeword(Codeword visited) const {
    return to_codeword_ ? (*to_codeword_)(visited) : visited;
  }
  Codeword to_visited(Codeword word) const { return to_visited_ ? (*to_visited_)(word) : word; }

  /// Prime, so odd: its multiples run through all words.
  static constexpr std::uint64_t kStep = 982451653;

 private:
  int bits_;
  Codeword start_;
  std::optional<BitPermutation> to_visited_;  // none: the same order
  std::optional<BitPermutation> to_codeword_;
};

}  // namespace tagmint::codec
