// The inner loops of the tree of open words, scalar beside vector.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "search/leaf_paint.h"
#include "search/near_list.h"

namespace tagmint::codec {
namespace {

constexpr std::size_t kEntries = 400;

/// Entries with radii of 0 .. 7.
NearList random_list(std::size_t count) {
  std::mt19937 random(1);
  NearList list;
  for (std::size_t i = 0; i < count; ++i) {
    list.push_back(near_entry(random(), static_cast<int>(random() % 8)));
  }
  return list;
}

/// Items are entries.
template <typename Narrow>
void narrow_entries(benchmark::State& state, Narrow narrow) {
  const NearList list = random_list(kEntries);
  const near_kernels::Narrowing narrowing{NearEntry{0x9} << 16, NearEntry{0xf} << 16,
                                          near_entry(0, 2), near_entry(0, 7)};
  std::vector<NearEntry> out(kEntries + NearList::kPadding);
  for (auto _ : state) {
    benchmark::DoNotOptimize(narrow(list.data(), list.size(), narrowing, out.data()));
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t{kEntries});
}
BENCHMARK_CAPTURE(narrow_entries, vector, near_kernels::narrow);
BENCHMARK_CAPTURE(narrow_entries, scalar, near_kernels::narrow_scalar);

/// Items are entries.
template <typename Part>
void part_entries(benchmark::State& state, Part part) {
  const NearList list = random_list(kEntries);
  std::vector<NearEntry> equal(kEntries + NearList::kPadding);
  std::vector<NearEntry> larger(kEntries + NearList::kPadding);
  for (auto _ : state) {
    benchmark::DoNotOptimize(part(list.data(), list.size(), 3, equal.data(), larger.data()));
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t{kEntries});
}
BENCHMARK_CAPTURE(part_entries, vector, near_kernels::part);
BENCHMARK_CAPTURE(part_entries, scalar, near_kernels::part_scalar);

/// Which of 42,211 codes of 48 bits reach a subtree of 24; items are turns.
template <typename Reach>
void reach_subtree(benchmark::State& state, Reach reach) {
  constexpr int kBits = 48;
  std::mt19937_64 random(2);
  std::vector<Codeword> words(4 * 42'211);
  for (Codeword& word : words) word = random() & low_mask(kBits);
  const SplitTurns turns(words);
  const near_kernels::Subtree subtree{random() & low_mask(kBits) & ~low_mask(kNearBits),
                                      kNearBitsMask, 11};
  std::vector<NearEntry> out(words.size() + NearList::kPadding);
  for (auto _ : state) benchmark::DoNotOptimize(reach(turns, subtree, out.data()));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(words.size()));
}
BENCHMARK_CAPTURE(reach_subtree, vector, near_kernels::reach);
BENCHMARK_CAPTURE(reach_subtree, scalar, near_kernels::reach_scalar);

/// Forty words against entries that exclude most of them; items are comparisons, as many as there
/// were if every word met every entry.
template <typename KeepOpen>
void keep_open_words(benchmark::State& state, KeepOpen keep_open) {
  constexpr std::size_t kWords = 40;
  constexpr NearEntry kWordMask = 0xffff;
  std::mt19937 random(3);
  NearList list;
  for (std::size_t i = 0; i < kEntries; ++i) list.push_back(near_entry(random(), 3));
  std::vector<std::uint32_t> words(kWords);
  for (std::uint32_t& word : words) word = random() & kWordMask;
  std::vector<std::uint32_t> buffer(kWords);
  for (auto _ : state) {
    std::copy(words.begin(), words.end(), buffer.begin());
    benchmark::DoNotOptimize(
        keep_open(list.data(), list.size(), std::span<std::uint32_t>(buffer), kWordMask));
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t{kWords * kEntries});
}
BENCHMARK_CAPTURE(keep_open_words, vector, near_kernels::keep_open);
BENCHMARK_CAPTURE(keep_open_words, scalar, near_kernels::keep_open_scalar);

/// Balls of radius 5, painted up to two rows deep on the leaves of a twig; items are balls.
template <typename Paint>
void paint_twig(benchmark::State& state, Paint paint) {
  const LeafPainter painter;
  const NearList list = random_list(50);
  TwigBits twig{};
  for (auto _ : state) {
    paint(painter, list, twig);
    benchmark::DoNotOptimize(twig.elements.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(list.size()));
}
BENCHMARK_CAPTURE(paint_twig, vector,
                  [](const LeafPainter& painter, const NearList& list, TwigBits& twig) {
                    painter.paint(list, 5, 2, twig);
                  });
BENCHMARK_CAPTURE(paint_twig, scalar, [](const LeafPainter&, const NearList& list, TwigBits& twig) {
  LeafPainter::paint_scalar(list, 5, 2, twig);
});

}  // namespace
}  // namespace tagmint::codec
