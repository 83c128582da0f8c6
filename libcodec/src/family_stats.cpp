#include "tagmint/codec/family_stats.h"

#include <algorithm>
#include <cmath>

#include "pair_distances.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

/// Index of the first entry that is not zero; `none` when all are.
int first_used(const std::vector<std::uint64_t>& histogram, int none) {
  const auto used = std::find_if(histogram.begin(), histogram.end(), [](auto n) { return n > 0; });
  return used == histogram.end() ? none : static_cast<int>(used - histogram.begin());
}

}  // namespace

double false_accept_rate(std::size_t codes, int bits, int errors) {
  double words_at_distance = 1;  // C(bits, i), exact in a double up to 2^53 and near enough beyond
  double words_within = 1;
  for (int i = 1; i <= errors; ++i) {
    words_at_distance = words_at_distance * (bits - i + 1) / i;
    words_within += words_at_distance;
  }
  return std::min(1.0, 4.0 * static_cast<double>(codes) * std::ldexp(words_within, -bits));
}

FamilyStats family_stats(const Family& family, int threads) {
  const int bits = family.bits();
  const std::size_t entries = static_cast<std::size_t>(bits) + 1;
  const Level all{family.size(), family.min_hamming()};
  const std::vector<Codeword> codewords = first_codewords(family, family.size());
  const DistanceHistogram pairs =
      pair_histograms(codewords, bits, std::span(&all, 1), threads).front();

  FamilyStats stats;
  stats.distance_histogram.assign(pairs.begin(), pairs.begin() + bits + 1);
  stats.self_histogram.assign(entries, 0);
  for (const Codeword word : codewords) ++stats.self_histogram[self_distance(word, bits)];
  stats.min_hamming =
      std::min(first_used(stats.distance_histogram, bits), first_used(stats.self_histogram, bits));
  for (int errors = 0; errors <= bits / 2; ++errors) {
    stats.false_accept_rate.push_back(false_accept_rate(family.size(), bits, errors));
  }
  return stats;
}

}  // namespace tagmint::codec
