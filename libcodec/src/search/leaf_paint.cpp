#include "search/leaf_paint.h"

#include <algorithm>
#include <bit>

#define HWY_WANT_AVX3_DL
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "search/leaf_paint.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::codec::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// kStepsDown[top][row]: elements by which the ball of a row lies below that of row `top`.
constexpr auto kStepsDown = [] {
  std::array<std::array<std::ptrdiff_t, LeafPainter::kRows>, LeafPainter::kRows> steps{};
  for (unsigned top = 0; top < LeafPainter::kRows; ++top) {
    for (unsigned row = 0; row < LeafPainter::kRows; ++row) {
      steps[top][row] = std::popcount(top ^ row) * LeafPainter::kRadiusStride;
    }
  }
  return steps;
}();

/// `balls` points at radius 0, centre 0.
bool paint_vector(const NearEntry* entries, std::size_t count, const std::uint64_t* balls,
                  std::uint64_t* leaf) {
  const hn::CappedTag<std::uint64_t, LeafPainter::kRowElements> d;
  auto everywhere = hn::Set(d, ~std::uint64_t{0});
  // With vectors shorter than a row, one piece of all rows after the other.
  for (std::size_t piece = 0; piece < LeafPainter::kRowElements; piece += hn::Lanes(d)) {
    auto row0 = hn::Zero(d), row1 = row0, row2 = row0, row3 = row0;
    auto row4 = row0, row5 = row0, row6 = row0, row7 = row0;
    for (std::size_t i = 0; i < count; ++i) {
      const NearEntry entry = entries[i];
      const auto radius = static_cast<std::ptrdiff_t>(std::min(entry >> kNearBits, NearEntry{12}));
      const std::ptrdiff_t centre = entry & ((1u << LeafPainter::kRowBits) - 1);
      const std::uint64_t* ball =
          balls + radius * LeafPainter::kRadiusStride + centre * LeafPainter::kRowElements + piece;
      const auto& down = kStepsDown[entry >> LeafPainter::kRowBits & 7];
      row0 = hn::Or(row0, hn::Load(d, ball - down[0]));
      row1 = hn::Or(row1, hn::Load(d, ball - down[1]));
      row2 = hn::Or(row2, hn::Load(d, ball - down[2]));
      row3 = hn::Or(row3, hn::Load(d, ball - down[3]));
      row4 = hn::Or(row4, hn::Load(d, ball - down[4]));
      row5 = hn::Or(row5, hn::Load(d, ball - down[5]));
      row6 = hn::Or(row6, hn::Load(d, ball - down[6]));
      row7 = hn::Or(row7, hn::Load(d, ball - down[7]));
    }
    constexpr std::size_t kRow = LeafPainter::kRowElements;
    hn::Store(row0, d, leaf + piece);
    hn::Store(row1, d, leaf + kRow + piece);
    hn::Store(row2, d, leaf + 2 * kRow + piece);
    hn::Store(row3, d, leaf + 3 * kRow + piece);
    hn::Store(row4, d, leaf + 4 * kRow + piece);
    hn::Store(row5, d, leaf + 5 * kRow + piece);
    hn::Store(row6, d, leaf + 6 * kRow + piece);
    hn::Store(row7, d, leaf + 7 * kRow + piece);
    const auto upper = hn::And(hn::And(row0, row1), hn::And(row2, row3));
    const auto lower = hn::And(hn::And(row4, row5), hn::And(row6, row7));
    everywhere = hn::And(everywhere, hn::And(upper, lower));
  }
  return hn::AllTrue(d, hn::Eq(everywhere, hn::Set(d, ~std::uint64_t{0})));
}

}  // namespace tagmint::codec::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::codec {

HWY_EXPORT(paint_vector);

LeafPainter::LeafPainter() {
  constexpr unsigned kCentres = 1u << kRowBits;
  for (int radius = kLeastRadius; radius <= kMostRadius; ++radius) {
    for (unsigned centre = 0; centre < kCentres; ++centre) {
      Row& row = balls_.emplace_back();
      row.elements.fill(0);
      for (unsigned word = 0; word < kCentres; ++word) {
        if (std::popcount(word ^ centre) <= radius) {
          row.elements[word / 64] |= std::uint64_t{1} << (word % 64);
        }
      }
    }
  }
}

bool LeafPainter::paint(const NearList& list, LeafBits& leaf) const {
  const std::uint64_t* balls = balls_.front().elements.data() - kLeastRadius * kRadiusStride;
  return HWY_DYNAMIC_DISPATCH(paint_vector)(list.data(), list.size(), balls, leaf.elements.data());
}

bool LeafPainter::paint_scalar(const NearList& list, LeafBits& leaf) {
  leaf.elements.fill(0);
  constexpr unsigned kWords = 4096;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const NearEntry entry = list.data()[i];
    for (unsigned word = 0; word < kWords; ++word) {
      if (std::popcount((entry ^ word) & (kWords - 1)) <= radius_of(entry)) {
        leaf.elements[word / 64] |= std::uint64_t{1} << (word % 64);
      }
    }
  }
  return std::all_of(leaf.elements.begin(), leaf.elements.end(),
                     [](std::uint64_t element) { return element == ~std::uint64_t{0}; });
}

}  // namespace tagmint::codec
#endif  // HWY_ONCE
