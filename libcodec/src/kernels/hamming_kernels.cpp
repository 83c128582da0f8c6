#include "kernels/hamming_kernels.h"

#include <algorithm>

// Highway compiles this file once for each set of instructions, also for the AVX-512 that counts
// bits, which it leaves out unless asked.
#define HWY_WANT_AVX3_DL
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/hamming_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::codec {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Words = hn::ScalableTag<std::uint64_t>;
using Signed = hn::RebindToSigned<Words>;
using WordVector = hn::Vec<Words>;
using DistanceVector = hn::Vec<Signed>;
using DistanceMask = hn::Mask<Signed>;

/// Distances are small, so they may be compared as signed numbers, which is cheaper.
HWY_ATTR DistanceVector distances(WordVector words, WordVector probe) {
  return hn::BitCast(Signed(), hn::PopulationCount(hn::Xor(words, probe)));
}

/// The four probes, each in all lanes.
struct ProbeVectors {
  WordVector p0, p1, p2, p3;
};

HWY_ATTR ProbeVectors broadcast(const FourTurns& probes) {
  const Words d;
  return {hn::Set(d, probes[0]), hn::Set(d, probes[1]), hn::Set(d, probes[2]),
          hn::Set(d, probes[3])};
}

HWY_ATTR DistanceVector least_distances(WordVector words, const ProbeVectors& p) {
  return hn::Min(hn::Min(distances(words, p.p0), distances(words, p.p1)),
                 hn::Min(distances(words, p.p2), distances(words, p.p3)));
}

/// The first word for which `near(vector of words)` is true in its lane. Four vectors are tested
/// with one branch; only where one of them hits are they looked at singly.
template <typename Near>
HWY_ATTR std::size_t find_first(std::span<const Codeword> words, const Near& near) {
  const Words d;
  const Signed ds;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + 4 * lanes <= words.size(); i += 4 * lanes) {
    const DistanceMask hit01 =
        hn::Or(near(hn::LoadU(d, &words[i])), near(hn::LoadU(d, &words[i + lanes])));
    const DistanceMask hit23 = hn::Or(near(hn::LoadU(d, &words[i + 2 * lanes])),
                                      near(hn::LoadU(d, &words[i + 3 * lanes])));
    if (!hn::AllFalse(ds, hn::Or(hit01, hit23))) break;
  }
  for (; i + lanes <= words.size(); i += lanes) {
    const auto lane = hn::FindFirstTrue(ds, near(hn::LoadU(d, &words[i])));
    if (lane >= 0) return i + static_cast<std::size_t>(lane);
  }
  return i;
}

HWY_ATTR std::size_t first_within_one(std::span<const Codeword> words, Codeword probe, int radius) {
  const WordVector probes = hn::Set(Words(), probe);
  const DistanceVector limit = hn::Set(Signed(), std::int64_t{radius} + 1);
  const std::size_t i =
      find_first(words, [&](WordVector v) HWY_ATTR { return hn::Lt(distances(v, probes), limit); });
  // Either a hit, or the few words after the last whole vector.
  return i + scalar::first_within(words.subspan(i), probe, radius);
}

HWY_ATTR std::size_t first_within_four(std::span<const Codeword> words, const FourTurns& probes,
                                       int radius) {
  const ProbeVectors vectors = broadcast(probes);
  const DistanceVector limit = hn::Set(Signed(), std::int64_t{radius} + 1);
  const std::size_t i = find_first(
      words, [&](WordVector v) HWY_ATTR { return hn::Lt(least_distances(v, vectors), limit); });
  return i + scalar::first_within(words.subspan(i), probes, radius);
}

/// Adds distance(vector of words) of each whole vector of words to the histogram; returns how many
/// words that are.
template <typename Distance>
HWY_ATTR std::size_t add_whole_vectors(std::span<const Codeword> words, const Distance& distance,
                                       DistanceHistogram& histogram) {
  const Words d;
  const Signed ds;
  const std::size_t lanes = hn::Lanes(d);
  HWY_ALIGN std::int64_t found[hn::MaxLanes(Signed())];
  // Most distances are much alike, and a counter cannot be raised again before the last time is
  // through: neighbouring lanes raise counters of different copies.
  DistanceHistogram copies[4] = {};
  std::size_t i = 0;
  for (; i + lanes <= words.size(); i += lanes) {
    hn::Store(distance(hn::LoadU(d, &words[i])), ds, found);
    for (std::size_t lane = 0; lane < lanes; ++lane) ++copies[lane % 4][found[lane]];
  }
  for (const DistanceHistogram& copy : copies) {
    for (std::size_t at = 0; at < copy.size(); ++at) histogram[at] += copy[at];
  }
  return i;
}

HWY_ATTR void add_distances_to_one(std::span<const Codeword> words, Codeword probe,
                                   DistanceHistogram& histogram) {
  const WordVector probes = hn::Set(Words(), probe);
  const std::size_t done = add_whole_vectors(
      words, [&](WordVector v) HWY_ATTR { return distances(v, probes); }, histogram);
  scalar::add_distances(words.subspan(done), probe, histogram);
}

HWY_ATTR void add_distances_to_four(std::span<const Codeword> words, const FourTurns& probes,
                                    DistanceHistogram& histogram) {
  const ProbeVectors vectors = broadcast(probes);
  const std::size_t done = add_whole_vectors(
      words, [&](WordVector v) HWY_ATTR { return least_distances(v, vectors); }, histogram);
  scalar::add_distances(words.subspan(done), probes, histogram);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::codec
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::codec {
namespace {

HWY_EXPORT(first_within_one);
HWY_EXPORT(first_within_four);
HWY_EXPORT(add_distances_to_one);
HWY_EXPORT(add_distances_to_four);

int least_distance(Codeword word, const FourTurns& probes) {
  return std::min(std::min(hamming_distance(word, probes[0]), hamming_distance(word, probes[1])),
                  std::min(hamming_distance(word, probes[2]), hamming_distance(word, probes[3])));
}

}  // namespace

std::size_t first_within(std::span<const Codeword> words, Codeword probe, int radius) {
  return HWY_DYNAMIC_DISPATCH(first_within_one)(words, probe, radius);
}

std::size_t first_within(std::span<const Codeword> words, const FourTurns& probes, int radius) {
  return HWY_DYNAMIC_DISPATCH(first_within_four)(words, probes, radius);
}

void add_distances(std::span<const Codeword> words, Codeword probe, DistanceHistogram& histogram) {
  HWY_DYNAMIC_DISPATCH(add_distances_to_one)(words, probe, histogram);
}

void add_distances(std::span<const Codeword> words, const FourTurns& probes,
                   DistanceHistogram& histogram) {
  HWY_DYNAMIC_DISPATCH(add_distances_to_four)(words, probes, histogram);
}

namespace scalar {

std::size_t first_within(std::span<const Codeword> words, Codeword probe, int radius) {
  std::size_t i = 0;
  while (i < words.size() && hamming_distance(words[i], probe) > radius) ++i;
  return i;
}

std::size_t first_within(std::span<const Codeword> words, const FourTurns& probes, int radius) {
  std::size_t i = 0;
  while (i < words.size() && least_distance(words[i], probes) > radius) ++i;
  return i;
}

void add_distances(std::span<const Codeword> words, Codeword probe, DistanceHistogram& histogram) {
  for (const Codeword word : words) ++histogram[hamming_distance(word, probe)];
}

void add_distances(std::span<const Codeword> words, const FourTurns& probes,
                   DistanceHistogram& histogram) {
  for (const Codeword word : words) ++histogram[least_distance(word, probes)];
}

}  // namespace scalar
}  // namespace tagmint::codec
#endif  // HWY_ONCE
