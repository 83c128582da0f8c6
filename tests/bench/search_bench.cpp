// Whole searches and their inner loops. Run with --benchmark_repetitions=5 and read the medians.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "search/distance_filter.h"
#include "search/engines.h"
#include "search/turn_blocks.h"
#include "search/walk_sieve.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"
#include "tagmint/codec/search/order.h"

namespace tagmint::codec {
namespace {

LexicodeOptions options_for(const char* layout, int min_hamming, const char* order,
                            const char* complexity, int threads) {
  return {.layout = parse_layout(layout),
          .min_hamming = min_hamming,
          .order = parse_order(order),
          .complexity = parse_complexity(complexity),
          .threads = threads};
}

/// Runs one search an iteration and checks the number of its codes.
void search(benchmark::State& state, const LexicodeOptions& options, std::size_t codes) {
  std::uint64_t words = 0;
  for (auto _ : state) {
    const LexicodeResult result = search_lexicode(options);
    if (result.codewords.size() != codes) state.SkipWithError("wrong number of codes");
    words += result.words_searched;
  }
  state.counters["words/s"] =
      benchmark::Counter(static_cast<double>(words), benchmark::Counter::kIsRate);
}

/// The searches take the number of threads as their argument; 0 = all cores.
#define TAGMINT_SEARCH_BENCH(name, codes, layout, distance, order, complexity)                 \
  void name(benchmark::State& state) {                                                         \
    search(state,                                                                              \
           options_for(layout, distance, order, complexity, static_cast<int>(state.range(0))), \
           codes);                                                                             \
  }                                                                                            \
  BENCHMARK(name)                                                                              \
      ->Arg(1)                                                                                 \
      ->Arg(0)                                                                                 \
      ->Unit(benchmark::kMillisecond)                                                          \
      ->UseRealTime()                                                                          \
      ->MeasureProcessCPUTime()

TAGMINT_SEARCH_BENCH(Tag16h5, 30, "classic:8", 5, "apriltag2", "rectangles:5");
TAGMINT_SEARCH_BENCH(TagCircle21h7, 38, "circle:9", 7, "apriltag3", "energy:0.3333");
TAGMINT_SEARCH_BENCH(Tag25h9, 35, "classic:9", 9, "apriltag2", "rectangles:8");
TAGMINT_SEARCH_BENCH(TagStandard25h9, 35, "standard:7", 9, "apriltag3", "energy:0.3333");
TAGMINT_SEARCH_BENCH(Tag36h11, 587, "classic:10", 11, "apriltag2", "rectangles:10");
TAGMINT_SEARCH_BENCH(Tag36h10, 2320, "classic:10", 10, "apriltag2", "rectangles:10");

/// The plain walk over the first 10 million words of tag36h11.
void PlainWalk36h11(benchmark::State& state) {
  LexicodeOptions options =
      options_for("classic:10", 11, "apriltag2", "rectangles:10", static_cast<int>(state.range(0)));
  options.limit_words = 10'000'000;
  for (auto _ : state) benchmark::DoNotOptimize(search_plain(options));
  state.SetItemsProcessed(state.iterations() * 10'000'000);
}
BENCHMARK(PlainWalk36h11)
    ->Arg(1)
    ->Arg(0)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

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
