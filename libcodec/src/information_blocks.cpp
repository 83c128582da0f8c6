#include "information_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

namespace tagmint::codec {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// How many ways to share the bits out are tried. Most have the fewest candidates that there can
/// be; a few blocks more or fewer cost little.
constexpr int kTries = 64;

/// The fixed cost of a block in candidates: its look-ups and the start of a scan take as long as
/// looking at 40 to 90 listed words (bench/decoder_bench).
constexpr double kBlockCost = 40;

/// Most entries of a block's list of error patterns, all cosets together: 4 MiB.
constexpr double kMostPatterns = 1 << 19;

/// Number of patterns of at most `errors` errors in `positions` bits.
double count_patterns(std::size_t positions, int errors) {
  double patterns = 1;
  double of_weight = 1;  // C(positions, weight)
  for (int weight = 1; weight <= errors; ++weight) {
    of_weight *= static_cast<double>(positions) - weight + 1;
    of_weight /= weight;
    patterns += of_weight;
  }
  return patterns;
}

/// Shares the positions out: each block takes what is free of those that are left.
std::vector<InformationBlock> share_out(std::span<const Codeword> basis, std::vector<int> left) {
  std::vector<InformationBlock> blocks;
  while (!left.empty()) {
    InformationBlock block = make_block(basis, left);
    if (block.positions.empty()) break;  // in what is left all sums are 0
    std::erase_if(left, [&](int position) {
      return std::find(block.positions.begin(), block.positions.end(), position) !=
             block.positions.end();
    });
    blocks.push_back(std::move(block));
  }
  return blocks;
}

double candidates_in(const InformationBlock& block, int errors) {
  return std::ldexp(count_patterns(block.positions.size(), errors),
                    static_cast<int>(block.kernel.size()));
}

double cost_of(const InformationBlock& block, int errors, std::size_t cosets) {
  const auto each = static_cast<double>(cosets);
  const bool listable = count_patterns(block.positions.size(), errors) * each <= kMostPatterns;
  if (!listable && errors > 0) return kNever;
  return kBlockCost + candidates_in(block, errors) * each;
}

/// Errors for some of the blocks, by their indices, and what they cost.
struct Errors {
  double cost = kNever;
  std::vector<std::pair<std::size_t, int>> of_block;
};

/// The cheapest errors for given blocks. A block with `errors` errors serves errors + 1 of the
/// radius + 1 that are needed: best[s] is the cheapest way for the blocks so far to serve s or
/// more.
Errors cheapest_errors(std::span<const InformationBlock> blocks, std::size_t cosets, int radius) {
  const int needed = radius + 1;
  std::vector<Errors> best(static_cast<std::size_t>(needed) + 1);
  best[0].cost = 0;
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    std::vector<Errors> next = best;
    const int most = std::min(static_cast<int>(blocks[block].positions.size()), needed) - 1;
    for (int errors = 0; errors <= most; ++errors) {
      const double cost = cost_of(blocks[block], errors, cosets);
      for (int served = 0; served < needed && cost < kNever; ++served) {
        const Errors& before = best[served];
        Errors& after = next[std::min(served + errors + 1, needed)];
        if (before.cost + cost >= after.cost) continue;
        after = before;
        after.of_block.emplace_back(block, errors);
        after.cost += cost;
      }
    }
    best = std::move(next);
  }
  return best[needed];
}

}  // namespace

InformationBlock make_block(std::span<const Codeword> basis, std::span<const int> positions) {
  InformationBlock block;
  block.kernel.assign(basis.begin(), basis.end());
  for (const int position : positions) {
    const Codeword bit = Codeword{1} << position;
    const auto pivot = std::find_if(block.kernel.begin(), block.kernel.end(),
                                    [&](Codeword word) { return (word & bit) != 0; });
    if (pivot == block.kernel.end()) continue;
    const Codeword column = *pivot;
    block.kernel.erase(pivot);
    for (std::vector<Codeword>* words : {&block.columns, &block.kernel}) {
      for (Codeword& word : *words) word ^= (word & bit) != 0 ? column : 0;
    }
    block.positions.push_back(position);
    block.columns.push_back(column);
  }
  return block;
}

double count_candidates(const BlockSearch& search) {
  return candidates_in(search.block, search.errors);
}

std::vector<BlockSearch> plan_search(std::span<const Codeword> basis, int bits, std::size_t cosets,
                                     int radius) {
  std::vector<BlockSearch> plan = {{make_block(basis, {}), 0}};
  double cost = cost_of(plan.front().block, 0, cosets);
  std::vector<int> positions(static_cast<std::size_t>(bits));
  std::iota(positions.begin(), positions.end(), 0);
  std::mt19937_64 random(1);
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const std::vector<InformationBlock> blocks = share_out(basis, positions);
    const Errors errors = cheapest_errors(blocks, cosets, radius);
    if (errors.cost < cost) {
      plan.clear();
      for (const auto& [block, most] : errors.of_block) plan.push_back({blocks[block], most});
      cost = errors.cost;
    }
    for (std::size_t i = positions.size(); i > 1; --i) {
      std::swap(positions[i - 1], positions[random() % i]);
    }
  }
  return plan;
}

}  // namespace tagmint::codec
