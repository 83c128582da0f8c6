#include "tagmint/codec/id_distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "pair_distances.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

int compared_distance(std::span<const Codeword> codewords, int bits, int threads) {
  const Level all{codewords.size(), 1};
  const DistanceHistogram pairs =
      pair_histograms(codewords, bits, std::span(&all, 1), threads).front();
  const auto nearest = std::find_if(pairs.begin(), pairs.end(), [](auto n) { return n > 0; });
  int distance = nearest == pairs.end() ? bits : static_cast<int>(nearest - pairs.begin());
  for (const Codeword word : codewords) distance = std::min(distance, self_distance(word, bits));
  return distance;
}

}  // namespace

std::size_t level_of_id(const Family& family, TagId last_id) {
  const std::span<const Level> levels = family.levels();
  const auto level = std::find_if(levels.begin(), levels.end(),
                                  [&](const Level& each) { return last_id < each.codes; });
  return static_cast<std::size_t>(level - levels.begin());
}

int distance_of_ids(const Family& family, std::span<const TagId> ids, int threads) {
  std::vector<TagId> sorted(ids.begin(), ids.end());
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.empty()) return family.min_hamming();
  if (sorted.back() >= family.size()) {
    throw std::invalid_argument(fmt::format("id {} is not in {}, which has ids 0 to {}",
                                            sorted.back(), family.name(), family.size() - 1));
  }
  const Level& level = family.levels()[level_of_id(family, sorted.back())];
  const bool whole_level = sorted.size() == level.codes;
  if (whole_level || sorted.size() > kMostComparedIds) return level.min_hamming;
  std::vector<Codeword> codewords;
  codewords.reserve(sorted.size());
  for (const TagId id : sorted) codewords.push_back(family.codeword(id));
  return compared_distance(codewords, family.bits(), threads);
}

}  // namespace tagmint::codec
