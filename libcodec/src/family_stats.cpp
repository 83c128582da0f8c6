#include "tagmint/codec/family_stats.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "codeword_stretches.h"
#include "level_distances.h"
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

namespace {

/// How many of the tags of each level pass the rule, by judging each.
void count_passing(const Family& family, int threads, std::vector<LevelStats>& levels) {
  const ComplexityJudge judge(family.layout(), family.complexity());
  const int workers = thread_count(threads);
  std::vector<std::vector<std::size_t>> parts(workers, std::vector<std::size_t>(levels.size()));
  for_each_stretch(family, workers,
                   [&](int worker, TagId first, std::span<const Codeword> codewords) {
                     std::size_t level = 0;
                     for (std::size_t i = 0; i < codewords.size(); ++i) {
                       while (first + i >= levels[level].codes) ++level;
                       parts[worker][level] += judge.accepts(codewords[i]);
                     }
                   });
  std::size_t passing = 0;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    for (const auto& part : parts) passing += part[level];
    levels[level].passing = passing;
  }
}

void add_listed(const Family& family, int threads, FamilyStats& stats) {
  const int bits = family.bits();
  const auto histograms = pair_histograms(family.codewords(), bits, family.levels(), threads);
  stats.distance_histogram.assign(static_cast<std::size_t>(bits) + 1, 0);
  int least = bits;
  TagId id = 0;
  for (std::size_t level = 0; level < family.levels().size(); ++level) {
    const std::size_t codes = family.levels()[level].codes;
    for (; id < codes; ++id) least = std::min(least, self_distance(family.codeword(id), bits));
    for (int distance = 0; distance <= bits; ++distance) {
      stats.distance_histogram[distance] += histograms[level][distance];
    }
    least = std::min(least, first_used(stats.distance_histogram, bits));
    stats.levels.push_back({codes, least, 0});
  }
  count_passing(family, threads, stats.levels);
}

void add_generated(const Family& family, int threads, FamilyStats& stats) {
  const RotationCode& code = *family.generator();
  std::size_t plain = 0;
  for (std::size_t level = 0; level < code.levels().size(); ++level) {
    const DistanceHistogram distances = level_distances(code, level, threads);
    plain += family.index()->plain(level);
    stats.levels.push_back({code.tags(level),
                            tag_distance(*family.index(), level, distances, threads),
                            code.tags(level) - plain});
    if (level + 1 < code.levels().size()) continue;
    const auto cosets = static_cast<double>(code.cosets().size());
    for (int distance = 0; distance <= family.bits(); ++distance) {
      stats.word_distances.push_back(static_cast<double>(distances[distance]) / cosets);
    }
  }
}

std::vector<std::uint64_t> self_histogram(const Family& family, int threads) {
  const int bits = family.bits();
  const int workers = thread_count(threads);
  std::vector<DistanceHistogram> parts(workers, DistanceHistogram{});
  for_each_stretch(family, workers, [&](int worker, TagId, std::span<const Codeword> codewords) {
    for (const Codeword word : codewords) ++parts[worker][self_distance(word, bits)];
  });
  std::vector<std::uint64_t> sum(static_cast<std::size_t>(bits) + 1, 0);
  for (const DistanceHistogram& part : parts) {
    std::transform(sum.begin(), sum.end(), part.begin(), sum.begin(), std::plus<>());
  }
  return sum;
}

}  // namespace

FamilyStats family_stats(const Family& family, int threads) {
  FamilyStats stats;
  if (family.is_listed()) {
    add_listed(family, threads, stats);
  } else {
    add_generated(family, threads, stats);
  }
  stats.self_histogram = self_histogram(family, threads);
  stats.min_hamming = stats.levels.back().min_hamming;
  for (int errors = 0; errors <= family.bits() / 2; ++errors) {
    stats.false_accept_rate.push_back(false_accept_rate(family.size(), family.bits(), errors));
  }
  return stats;
}

}  // namespace tagmint::codec
