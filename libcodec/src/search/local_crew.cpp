#include "search/local_crew.h"

#include <atomic>

#include "search/paint_radius.h"
#include "search/parallel.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

/// A permutation of the subtrees, so that those done so far are a fair sample of all. (Their number
/// is a power of two and the factor is odd.)
std::uint64_t scattered(std::uint64_t i, std::uint64_t subtrees) {
  constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15;  // 2^64 / golden ratio
  return i * kOdd & (subtrees - 1);
}

std::vector<Codeword> turns_as_tree_words(std::span<const Codeword> codes, const TreeOrder& order) {
  std::vector<Codeword> turns;
  turns.reserve(4 * codes.size());
  for (const Codeword code : codes) {
    for (int turn = 0; turn < 4; ++turn) {
      turns.push_back(order.to_tree(rotate(code, order.bits(), turn)));
    }
  }
  return turns;
}

}  // namespace

LocalCrew::Forest::Forest(int bits, int min_hamming, std::span<const Codeword> codes, int threads,
                          std::optional<int> paint_radius)
    : order(bits), turns(turns_as_tree_words(codes, order)) {
  const int radius = min_hamming - 1;
  const int painted = paint_radius.value_or(best_paint_radius(bits, radius, turns.size()));
  trees.reserve(threads);
  for (int i = 0; i < threads; ++i) trees.emplace_back(order, painter, turns, radius, painted);
}

LocalCrew::LocalCrew(const SearchRules& rules, int threads, const LocalCrewTuning& tuning)
    : rules_(rules),
      threads_(thread_count(threads)),
      tuning_(tuning),
      walk_(rules.layout, rules.order,
            walk_seed(rules.order, rules.layout, rules.min_hamming, rules.complexity)),
      sieve_(rules, walk_, threads_) {}

void LocalCrew::learn(std::span<const Codeword> codes) {
  sieve_.learn(codes);
  codes_.insert(codes_.end(), codes.begin(), codes.end());
  forest_.reset();
}

SiftedWords LocalCrew::sift(std::uint64_t first, std::uint64_t count) {
  return tuning_.walk_by_groups ? sieve_.sift_walk(first, count) : sieve_.sift_each(first, count);
}

std::vector<Codeword> LocalCrew::list_subtree(OpenWordTree& tree, std::uint64_t subtree) const {
  std::vector<Codeword> found;
  tree.list_subtree(scattered(subtree, OpenWordTree::subtree_count(forest_->order)), found);
  for (Codeword& word : found) word = forest_->order.to_codeword(word);
  std::erase_if(found, [this](Codeword word) {
    return self_distance(word, walk_.bits()) < rules_.min_hamming;
  });
  return found;
}

std::vector<Codeword> LocalCrew::list_open(std::uint64_t first, std::uint64_t count) {
  if (!forest_) {
    forest_ = std::make_unique<Forest>(walk_.bits(), rules_.min_hamming, codes_, threads_,
                                       tuning_.paint_radius);
  }
  std::vector<std::vector<Codeword>> open(threads_);
  std::atomic<std::uint64_t> next{0};
  run_workers(threads_, [&](int worker) {
    OpenWordTree& tree = forest_->trees[worker];
    for (std::uint64_t i; (i = next++) < count;) {
      const std::vector<Codeword> found = list_subtree(tree, first + i);
      open[worker].insert(open[worker].end(), found.begin(), found.end());
    }
  });
  std::vector<Codeword> all = std::move(open.front());
  for (int worker = 1; worker < threads_; ++worker) {
    all.insert(all.end(), open[worker].begin(), open[worker].end());
  }
  return all;
}

std::chrono::duration<double> LocalCrew::round_length() const {
  // The more codes, the longer the stretches that pay for the groups of WalkSieve.
  constexpr std::size_t kManyCodes = 10'000;
  return std::chrono::milliseconds(codes_.size() < kManyCodes ? 200 : 1000);
}

std::uint64_t subtree_count(int bits) { return OpenWordTree::subtree_count(TreeOrder(bits)); }

std::unique_ptr<SearchCrew> local_crew(const SearchRules& rules, int threads) {
  return std::make_unique<LocalCrew>(rules, threads);
}

}  // namespace tagmint::codec
