#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/near_list.h"
#include "tagmint/codec/search/bit_permutation.h"

namespace tagmint::codec {

/// One bit for each of the 4096 words of a leaf; 1 = excluded. Word w is bit w % 64 of element
/// w / 64.
struct alignas(64) LeafBits {
  std::array<std::uint64_t, 64> elements;
};

/// Paints Hamming balls on leaves. The 4096 words are eight rows of 512, one for each value of the
/// upper three bits. A ball of radius r about centre (top, rest) meets row j in a ball of radius
/// r - distance(j, top) about `rest`, and those 512-bit balls are looked up:
///
///     row 0  [ ball(rest, r - |0 ^ top|) ]
///     row 1  [ ball(rest, r - |1 ^ top|) ]      eight loads and eight ORs for an entry
///     ...
class LeafPainter {
 public:
  /// Makes the table of balls: 512 KiB, of which the rows of small radii are in use most.
  LeafPainter();

  /// Paints every entry of `list` with its radius; its low twelve bits are the centre.
  ///   returns  whether all 4096 words are excluded
  ///   cost     eight loads of 64 bytes for each entry
  bool paint(const NearList& list, LeafBits& leaf) const;

  /// The plain loop that paint() is tested against.
  static bool paint_scalar(const NearList& list, LeafBits& leaf);

  static constexpr int kRowBits = 9;
  static constexpr int kRows = 8;
  static constexpr int kRowElements = 8;           // 512 bits
  static constexpr int kLeastRadius = -3;          // of a row; balls below 0 are empty
  static constexpr int kMostRadius = 12;           // every word of a leaf
  static constexpr std::ptrdiff_t kRadiusStride =  // elements from one radius to the next
      std::ptrdiff_t{kRowElements} << kRowBits;

 private:
  struct alignas(64) Row {
    std::array<std::uint64_t, kRowElements> elements;
  };
  std::vector<Row> balls_;  // [radius - kLeastRadius][centre]
};

}  // namespace tagmint::codec
