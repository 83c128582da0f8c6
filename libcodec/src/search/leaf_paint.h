#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/near_list.h"

namespace tagmint::codec {

/// One bit for each of the 65536 words of a twig's 16 leaves; 1 = excluded. Word w is bit w % 64 of
/// element w / 64. Eight elements are a *row*: 512 words, one for each value of the nine low bits.
struct alignas(64) TwigBits {
  static constexpr int kWordBits = 16;
  static constexpr int kRowBits = 9;
  static constexpr std::size_t kRows = std::size_t{1} << (kWordBits - kRowBits);
  static constexpr std::size_t kRowElements = (std::size_t{1} << kRowBits) / 64;
  static constexpr std::size_t kElements = kRows * kRowElements;

  std::array<std::uint64_t, kElements> elements;
};

/// Paints Hamming balls on the leaves of a twig. The seven upper bits of a word number its row. A
/// ball of radius r about the centre [ row c | rest ] meets the rows in smaller balls about `rest`:
///
///     row c                  ball(rest, r)       1 row
///     rows one bit from c    ball(rest, r-1)     7 rows
///     rows two bits from c   ball(rest, r-2)    21 rows ...
///
/// These 512-bit balls come from a table; one is looked up for all rows at the same distance. Rows
/// far from c hardly gain from a ball, so that how far to go, the *depth*, is up to the caller.
class LeafPainter {
 public:
  static constexpr int kMostDepth = TwigBits::kWordBits - TwigBits::kRowBits;

  /// Makes the table of balls: 544 KiB, of which the parts of a few radii are in use.
  LeafPainter();

  /// Adds balls to `twig`.
  ///   list     centres: the sixteen low bits
  ///   radius   of all balls, whatever the entries say; >= 0
  ///   depth    0 .. kMostDepth: rows with at most so many differing bits are painted
  ///   cost     a load, an OR and a store of 64 bytes for each row painted
  void paint(const NearList& list, int radius, int depth, TwigBits& twig) const;

  /// Appends `prefix` | word for each word of one leaf that is not painted, in ascending order.
  ///   leaf     0 .. 15: the four upper bits of the words
  ///   prefix   the sixteen low bits are 0
  ///   cost     a load and a comparison for each row, some nanoseconds for each such word
  static void append_unpainted(const TwigBits& twig, unsigned leaf, std::uint32_t prefix,
                               std::vector<std::uint32_t>& words);

  /// The plain loop that paint() is tested against.
  static void paint_scalar(const NearList& list, int radius, int depth, TwigBits& twig);

  static constexpr std::size_t kLeafElements = TwigBits::kElements / 16;
  static constexpr int kMostRadius = TwigBits::kWordBits;  // all words of a twig
  static constexpr std::size_t kRadiusStride =             // elements of one radius
      TwigBits::kRowElements << TwigBits::kRowBits;

 private:
  struct alignas(64) Row {
    std::array<std::uint64_t, TwigBits::kRowElements> elements;
  };
  std::vector<Row> balls_;  // [radius][centre]
};

}  // namespace tagmint::codec
