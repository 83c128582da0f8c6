#include "tagmint/codec/id_distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <vector>

#include "pair_distances.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

bool is_ascending(std::span<const TagId> ids) {
  return std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end();
}

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

std::vector<TagId> ascending_ids(std::vector<TagId> ids) {
  if (is_ascending(ids)) return ids;
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

int distance_of_ids(const Family& family, std::span<const TagId> ids, int threads) {
  if (!is_ascending(ids)) {
    return distance_of_ids(family, ascending_ids({ids.begin(), ids.end()}), threads);
  }
  if (ids.empty()) return family.min_hamming();
  if (ids.back() >= family.size()) {
    throw std::invalid_argument(fmt::format("id {} is not in {}, which has ids 0 to {}", ids.back(),
                                            family.name(), family.size() - 1));
  }
  const Level& level = family.levels()[level_of_id(family, ids.back())];
  const bool whole_level = ids.size() == level.codes;
  if (whole_level || ids.size() > kMostComparedIds) return level.min_hamming;
  std::vector<Codeword> codewords;
  codewords.reserve(ids.size());
  for (const TagId id : ids) codewords.push_back(family.codeword(id));
  return compared_distance(codewords, family.bits(), threads);
}

}  // namespace tagmint::codec
