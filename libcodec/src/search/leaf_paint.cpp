#include "search/leaf_paint.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

#define HWY_WANT_AVX3_DL
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "search/leaf_paint.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#ifndef TAGMINT_CODEC_SEARCH_LEAF_PAINT_SHELLS
#define TAGMINT_CODEC_SEARCH_LEAF_PAINT_SHELLS
namespace tagmint::codec::leaf_paint {

/// The differences between two row numbers, the ones with fewer bits first.
inline constexpr auto kDifferences = [] {
  std::array<std::size_t, TwigBits::kRows> differences{};
  std::size_t next = 0;
  for (int bits = 0; bits <= LeafPainter::kMostDepth; ++bits) {
    for (std::size_t difference = 0; difference < TwigBits::kRows; ++difference) {
      if (std::popcount(difference) == bits) differences[next++] = difference;
    }
  }
  return differences;
}();

/// kShellStart[d]: the first of kDifferences with d bits.
inline constexpr auto kShellStart = [] {
  std::array<std::size_t, LeafPainter::kMostDepth + 2> start{};
  for (int depth = 0; depth <= LeafPainter::kMostDepth; ++depth) {
    start[depth + 1] = start[depth] + static_cast<std::size_t>(std::count_if(
                                          kDifferences.begin(), kDifferences.end(),
                                          [=](auto d) { return std::popcount(d) == depth; }));
  }
  return start;
}();

}  // namespace tagmint::codec::leaf_paint
#endif

HWY_BEFORE_NAMESPACE();
namespace tagmint::codec::leaf_paint::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<std::uint64_t, TwigBits::kRowElements>;

/// Paints one piece of a ball on the rows that differ from the centre's row in kDepth bits.
///   piece   of the ball
///   rows    the same piece of row 0
template <int kDepth, std::size_t... kIndex>
HWY_INLINE void paint_shell(hn::Vec<Tag> piece, std::size_t row, std::uint64_t* rows,
                            std::index_sequence<kIndex...>) {
  const Tag d;
  const auto paint_row = [&](std::size_t difference) HWY_ATTR {
    std::uint64_t* target = rows + (row ^ difference) * TwigBits::kRowElements;
    hn::Store(hn::Or(hn::Load(d, target), piece), d, target);
  };
  (paint_row(kDifferences[kShellStart[kDepth] + kIndex]), ...);
}

/// Paints one piece of a ball on the rows up to kDepth bits from the centre's.
///   ball   that piece of the ball on the centre's row
template <int kDepth>
HWY_INLINE void paint_shells(const std::uint64_t* ball, std::size_t row, std::uint64_t* rows) {
  if constexpr (kDepth > 0) paint_shells<kDepth - 1>(ball, row, rows);
  const std::uint64_t* smaller = ball - kDepth * LeafPainter::kRadiusStride;
  paint_shell<kDepth>(hn::Load(Tag(), smaller), row, rows,
                      std::make_index_sequence<kShellStart[kDepth + 1] - kShellStart[kDepth]>());
}

/// `balls` points at the ball about centre 0.
template <int kDepth>
void paint_balls(const NearEntry* entries, std::size_t count, const std::uint64_t* balls,
                 std::uint64_t* twig) {
  for (std::size_t i = 0; i < count; ++i) {
    const NearEntry entry = entries[i];
    const std::size_t centre = entry & ((1u << TwigBits::kRowBits) - 1);
    const std::size_t row = entry >> TwigBits::kRowBits & (TwigBits::kRows - 1);
    const std::uint64_t* ball = balls + centre * TwigBits::kRowElements;
    // With vectors shorter than a row, one piece of all rows after the other.
    for (std::size_t at = 0; at < TwigBits::kRowElements; at += hn::Lanes(Tag())) {
      paint_shells<kDepth>(ball + at, row, twig + at);
    }
  }
}

void paint_vector(const NearEntry* entries, std::size_t count, const std::uint64_t* balls,
                  int depth, std::uint64_t* twig) {
  constexpr std::array kByDepth = {paint_balls<0>, paint_balls<1>, paint_balls<2>, paint_balls<3>,
                                   paint_balls<4>, paint_balls<5>, paint_balls<6>, paint_balls<7>};
  static_assert(kByDepth.size() == LeafPainter::kMostDepth + 1);
  kByDepth[depth](entries, count, balls, twig);
}

/// Which elements of a leaf are not full: bit i for element i. Without a branch for each row, which
/// could not be foretold.
std::uint64_t find_gaps_vector(const std::uint64_t* leaf) {
  static_assert(LeafPainter::kLeafElements == 64);
  const Tag d;
  const auto full = hn::Set(d, ~std::uint64_t{0});
  std::uint64_t gaps = 0;
  for (std::size_t first = 0; first < LeafPainter::kLeafElements; first += hn::Lanes(d)) {
    std::uint8_t bits = 0;
    hn::StoreMaskBits(d, hn::Ne(hn::Load(d, leaf + first), full), &bits);
    gaps |= std::uint64_t{bits} << first;
  }
  return gaps;
}

}  // namespace tagmint::codec::leaf_paint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::codec {
namespace leaf_paint {
HWY_EXPORT(paint_vector);
HWY_EXPORT(find_gaps_vector);
}  // namespace leaf_paint

LeafPainter::LeafPainter() {
  // The ball of an element, 64 words, depends on its own six bits of the centre and on how many of
  // the upper three differ.
  constexpr int kElementBits = 6;
  constexpr unsigned kElementWords = 1u << kElementBits;
  constexpr unsigned kCentres = 1u << TwigBits::kRowBits;
  constexpr int kMostUpper = TwigBits::kRowBits - kElementBits;
  std::array<std::array<std::uint64_t, kElementWords>, kMostUpper + kMostRadius + 1> small{};
  for (int radius = 0; radius <= kMostRadius; ++radius) {
    for (unsigned centre = 0; centre < kElementWords; ++centre) {
      for (unsigned word = 0; word < kElementWords; ++word) {
        if (std::popcount(word ^ centre) > radius) continue;
        small[kMostUpper + radius][centre] |= std::uint64_t{1} << word;
      }
    }
  }
  for (int radius = 0; radius <= kMostRadius; ++radius) {
    for (unsigned centre = 0; centre < kCentres; ++centre) {
      Row& row = balls_.emplace_back();
      for (unsigned element = 0; element < TwigBits::kRowElements; ++element) {
        const int differing = std::popcount(centre >> kElementBits ^ element);
        row.elements[element] = small[kMostUpper + radius - differing][centre % kElementWords];
      }
    }
  }
}

void LeafPainter::paint(const NearList& list, int radius, int depth, TwigBits& twig) const {
  assert(radius >= 0 && depth >= 0 && depth <= kMostDepth);
  radius = std::min(radius, kMostRadius);
  depth = std::min(depth, radius);  // there are no balls of negative radius
  using namespace leaf_paint;
  const std::uint64_t* balls = balls_.front().elements.data() + radius * kRadiusStride;
  HWY_DYNAMIC_DISPATCH(paint_vector)
  (list.data(), list.size(), balls, depth, twig.elements.data());
}

void LeafPainter::append_unpainted(const TwigBits& twig, unsigned leaf, std::uint32_t prefix,
                                   std::vector<std::uint32_t>& words) {
  using namespace leaf_paint;
  const std::size_t start = leaf * kLeafElements;
  std::uint64_t gaps = HWY_DYNAMIC_DISPATCH(find_gaps_vector)(twig.elements.data() + start);
  for (; gaps != 0; gaps &= gaps - 1) {
    const std::size_t element = start + static_cast<std::size_t>(std::countr_zero(gaps));
    const std::uint32_t first = prefix | static_cast<std::uint32_t>(element * 64);
    for (std::uint64_t left = ~twig.elements[element]; left != 0; left &= left - 1) {
      words.push_back(first | static_cast<std::uint32_t>(std::countr_zero(left)));
    }
  }
}

void LeafPainter::paint_scalar(const NearList& list, int radius, int depth, TwigBits& twig) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (unsigned word = 0; word < 1u << TwigBits::kWordBits; ++word) {
      const unsigned differing = (list.data()[i] ^ word) & ((1u << TwigBits::kWordBits) - 1);
      if (std::popcount(differing) <= radius &&
          std::popcount(differing >> TwigBits::kRowBits) <= depth) {
        twig.elements[word / 64] |= std::uint64_t{1} << (word % 64);
      }
    }
  }
}

}  // namespace tagmint::codec
#endif  // HWY_ONCE
