// The tree of open words: subtrees of the families' spaces, and the kernels below them.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <vector>

#include "search/leaf_paint.h"
#include "search/open_word_tree.h"
#include "search/paint_radius.h"
#include "search/tree_order.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

/// The four turns of the first `count` codes of a bundled family, as tree words.
std::vector<Codeword> turns_of(const Family& family, std::size_t count, const TreeOrder& order) {
  std::vector<Codeword> turns;
  for (const Codeword code : family.codewords().first(count)) {
    for (int turn = 0; turn < 4; ++turn) {
      turns.push_back(order.to_tree(rotate(code, order.bits(), turn)));
    }
  }
  return turns;
}

/// A subtree of which all words stand for their tag, as nearly all do: 4096 leaves.
std::uint64_t random_whole_subtree(const TreeOrder& order, std::mt19937_64& random) {
  while (true) {
    const std::uint64_t subtree = random() & (OpenWordTree::subtree_count(order) - 1);
    TreeOrder::Ties ties;
    bool stands = true;
    for (int orbit = order.bits() / 4 - 7; orbit >= 0 && stands; --orbit) {
      const unsigned nibble = subtree >> (4 * orbit) & 0xf;
      stands = !TreeOrder::breaks_order(ties, nibble);
      ties = TreeOrder::after(ties, nibble);
    }
    if (stands && !ties.a_c && !ties.b_d) return subtree;
  }
}

/// One subtree an iteration. Arguments: paint radius, -1 = as the model has it; items are leaves.
void list_subtrees(benchmark::State& state, const char* name, std::size_t codes, int min_hamming) {
  const SharedFamily family = find_family(name);
  const TreeOrder order(family->layout().bits());
  const std::vector<Codeword> turns = turns_of(*family, codes, order);
  const int radius = min_hamming - 1;
  const int paint_radius = state.range(0) >= 0
                               ? static_cast<int>(state.range(0))
                               : best_paint_radius(order.bits(), radius, turns.size());
  const LeafPainter painter;
  OpenWordTree tree(order, painter, turns, radius, paint_radius);
  std::mt19937_64 random(1);
  std::vector<Codeword> open;
  for (auto _ : state) tree.list_subtree(random_whole_subtree(order, random), open);
  constexpr std::int64_t kLeaves = 4096;
  state.SetItemsProcessed(state.iterations() * kLeaves);
  state.counters["p"] = paint_radius;
  state.counters["deep"] =
      best_paint_plan(order.bits(), radius, turns.size(), paint_radius).deep_radius;
  state.counters["open/leaf"] =
      static_cast<double>(open.size()) / static_cast<double>(state.iterations() * kLeaves);
}
#define TAGMINT_TREE_BENCH(family, codes, distance)                                    \
  BENCHMARK_CAPTURE(list_subtrees, family##_##codes##_codes, #family, codes, distance) \
      ->Arg(-1)                                                                        \
      ->DenseRange(2, 5)                                                               \
      ->Unit(benchmark::kMillisecond)
TAGMINT_TREE_BENCH(tagCustom48h12, 42211, 12);
TAGMINT_TREE_BENCH(tag36h11, 386, 11);
TAGMINT_TREE_BENCH(tag36h10, 1600, 10);
TAGMINT_TREE_BENCH(tag36h9, 4000, 9);
TAGMINT_TREE_BENCH(tagStandard41h12, 1800, 12);
TAGMINT_TREE_BENCH(tagCircle49h12, 65535, 12);
TAGMINT_TREE_BENCH(tagStandard52h13, 48714, 13);

}  // namespace
}  // namespace tagmint::codec
