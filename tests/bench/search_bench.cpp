// The inner loops of the walk, scalar beside vector. Run with --benchmark_repetitions=5 and read
// the medians. whole_searches times whole searches.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "search/distance_filter.h"
#include "search/sieve_kernels.h"
#include "search/turn_blocks.h"
#include "search/turn_index.h"
#include "search/walk_sieve.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/rotation.h"
#include "tagmint/codec/search/order.h"

namespace tagmint::codec {
namespace {

/// 36-bit words against the turns of `codes` random codes, vector or scalar.
template <typename Filter>
void filter_words(benchmark::State& state, Filter filter) {
  constexpr int kBits = 36;
  std::mt19937_64 random(1);
  TurnBlocks blocks;
  for (int code = 0; code < state.range(0); ++code) {
    const Codeword word = random() & low_mask(kBits);
    blocks.add(
        std::array{word, rotate(word, kBits, 1), rotate(word, kBits, 2), rotate(word, kBits, 3)});
  }
  std::vector<Codeword> words(1024);
  for (Codeword& word : words) word = random() & low_mask(kBits);
  std::vector<std::uint32_t> kept(words.size());
  for (auto _ : state) benchmark::DoNotOptimize(filter(words, blocks, 11, kept.data()));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(words.size()));
}
BENCHMARK_CAPTURE(filter_words, vector, keep_distant)->Arg(30)->Arg(587);
BENCHMARK_CAPTURE(filter_words, scalar, keep_distant_scalar)->Arg(30)->Arg(587);

template <typename T>
std::vector<T> random_words(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<T> words(count + sieve_kernels::kPadding);
  for (T& word : words) word = static_cast<T>(random());
  return words;
}

/// 4096 words against 256 codes so near that one word in ten is left; items are comparisons, as
/// many as there were if every word met every code.
template <typename T>
void keep_far_words(benchmark::State& state,
                    std::size_t (*keep_far)(T*, std::size_t, const T*, std::size_t, int),
                    int min_hamming) {
  constexpr std::size_t kWords = 4096;
  constexpr std::size_t kCodes = 256;
  const std::vector<T> words = random_words<T>(kWords, 1);
  const std::vector<T> codes = random_words<T>(kCodes, 2);
  std::vector<T> buffer = words;
  std::size_t kept = 0;
  for (auto _ : state) {
    std::copy(words.begin(), words.end(), buffer.begin());
    kept = keep_far(buffer.data(), kWords, codes.data(), kCodes, min_hamming);
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t{kWords * kCodes});
  state.counters["kept"] = static_cast<double>(kept) / kWords;
}
constexpr auto keep_far_32 = keep_far_words<std::uint32_t>;
constexpr auto keep_far_64 = keep_far_words<std::uint64_t>;
BENCHMARK_CAPTURE(keep_far_32, vector, sieve_kernels::keep_far, 10);
BENCHMARK_CAPTURE(keep_far_32, scalar, sieve_kernels::keep_far_scalar, 10);
BENCHMARK_CAPTURE(keep_far_64, vector, sieve_kernels::keep_far, 23);
BENCHMARK_CAPTURE(keep_far_64, scalar, sieve_kernels::keep_far_scalar, 23);

/// The codes of all cells that differ from one in at most two of 16 bits, of 42,211 codes with 48
/// bits; items are cells.
template <typename Gather>
void gather_near_cells(benchmark::State& state, Gather gather) {
  constexpr int kBits = 48;
  constexpr int kFineBits = 16;
  std::vector<Codeword> turns = random_words<Codeword>(4 * 42'211, 3);
  for (Codeword& turn : turns) turn &= low_mask(kBits);
  const TurnIndex index(kBits, kFineBits, 0, turns);
  std::vector<std::uint32_t> masks;
  for (int weight = 0; weight <= 2; ++weight) {
    const std::vector<std::uint32_t> some = words_of_weight(kFineBits, weight);
    masks.insert(masks.end(), some.begin(), some.end());
  }
  std::vector<std::uint32_t> gathered(turns.size() + sieve_kernels::kPadding);
  std::uint32_t cell = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        gather(index.starts(), index.uppers(), cell, masks.data(), masks.size(), gathered.data()));
    cell = (cell + 0x9e37) % (1u << kFineBits);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(masks.size()));
}
BENCHMARK_CAPTURE(gather_near_cells, vector, sieve_kernels::gather_cells);
BENCHMARK_CAPTURE(gather_near_cells, scalar, sieve_kernels::gather_cells_scalar);

/// A stretch of 2^log_words words of the walk against the first codes of a bundled family.
void sieve_walk(benchmark::State& state, const char* name, std::size_t codes, int log_words) {
  const SharedFamily family = find_family(name);
  const int bits = family->layout().bits();
  std::vector<Codeword> turns;
  for (const Codeword code : family->codewords().first(codes)) {
    for (int turn = 0; turn < 4; ++turn) turns.push_back(rotate(code, bits, turn));
  }
  const std::uint64_t count = std::uint64_t{1} << log_words;
  const WalkSieve sieve(bits, family->min_hamming(), turns, count);
  WalkSieve::Scratch scratch;
  Codeword first = 1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(sieve.open_words(first, count, scratch));
    first += count * Walk::kStep;
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}
BENCHMARK_CAPTURE(sieve_walk, 36h11_400_codes, "tag36h11", 400, 22);
BENCHMARK_CAPTURE(sieve_walk, 41h12_2000_codes, "tagStandard41h12", 2000, 22);
BENCHMARK_CAPTURE(sieve_walk, 48h12_5000_codes, "tagCustom48h12", 5000, 22);
BENCHMARK_CAPTURE(sieve_walk, 48h12_20000_codes, "tagCustom48h12", 20000, 24);
BENCHMARK_CAPTURE(sieve_walk, 48h12_42211_codes, "tagCustom48h12", 42211, 24);
BENCHMARK_CAPTURE(sieve_walk, 49h12_65535_codes, "tagCircle49h12", 65535, 24);
BENCHMARK_CAPTURE(sieve_walk, 52h13_48714_codes, "tagStandard52h13", 48714, 24);

}  // namespace
}  // namespace tagmint::codec
