#include "kernels/nibble_planes.h"

#include <algorithm>
#include <array>
#include <bit>

#define HWY_WANT_AVX3_DL
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/nibble_planes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef TAGMINT_NIBBLE_DISTANCES
#define TAGMINT_NIBBLE_DISTANCES
namespace tagmint::codec {

/// Row v: the distances of the nibble v from 0 .. 15.
struct NibbleDistances {
  alignas(16) std::array<std::array<std::uint8_t, 16>, 16> from{};
};

constexpr NibbleDistances make_nibble_distances() {
  NibbleDistances table;
  for (unsigned a = 0; a < 16; ++a) {
    for (unsigned b = 0; b < 16; ++b) {
      table.from[a][b] = static_cast<std::uint8_t>(std::popcount(a ^ b));
    }
  }
  return table;
}

inline constexpr NibbleDistances kNibbleDistances = make_nibble_distances();

/// Blocks whose distances are kept before they are counted; 1,024 bytes.
inline constexpr std::size_t kBlocksCounted = 16;

}  // namespace tagmint::codec
#endif  // TAGMINT_NIBBLE_DISTANCES

HWY_BEFORE_NAMESPACE();
namespace tagmint::codec {
namespace HWY_NAMESPACE {
namespace {

/// Of each nibble of each probe the row of the table.
struct ProbeRows {
  std::array<std::array<const std::uint8_t*, 16>, 4> of{};
};

ProbeRows rows_of(const FourTurns& probes, int nibbles) {
  ProbeRows rows;
  for (std::size_t probe = 0; probe < 4; ++probe) {
    for (int k = 0; k < nibbles; ++k) {
      const auto nibble = probes[probe] >> (4 * (nibbles - 1 - k)) & 15;
      rows.of[probe][static_cast<std::size_t>(k)] = kNibbleDistances.from[nibble].data();
    }
  }
  return rows;
}

#if HWY_TARGET == HWY_SCALAR

// One lane holds no table: word by word.
void add_few_blocks(const NibblePlanes& planes, std::size_t first, std::size_t end,
                    const ProbeRows& rows, DistanceHistogram& histogram) {
  for (std::size_t block = first; block < end; ++block) {
    for (std::size_t lane = 0; lane < NibblePlanes::kBlockWords; ++lane) {
      std::array<unsigned, 4> sums{};
      const std::uint8_t* nibble = planes.block(block) + lane;
      for (int k = 0; k < planes.nibbles(); ++k, nibble += NibblePlanes::kBlockWords) {
        for (std::size_t probe = 0; probe < 4; ++probe) sums[probe] += rows.of[probe][k][*nibble];
      }
      ++histogram[*std::min_element(sums.begin(), sums.end())];
    }
  }
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using Bytes = hn::CappedTag<std::uint8_t, NibblePlanes::kBlockWords>;
using ByteVector = hn::Vec<Bytes>;

/// The least of the four distances of as many words as a vector has bytes.
HWY_ATTR ByteVector least_of_four(const std::uint8_t* plane, const ProbeRows& rows, int nibbles) {
  const Bytes d;
  ByteVector sum0 = hn::Zero(d);
  ByteVector sum1 = hn::Zero(d);
  ByteVector sum2 = hn::Zero(d);
  ByteVector sum3 = hn::Zero(d);
  for (int k = 0; k < nibbles; ++k, plane += NibblePlanes::kBlockWords) {
    const ByteVector words = hn::LoadU(d, plane);
    sum0 = hn::Add(sum0, hn::TableLookupBytes(hn::LoadDup128(d, rows.of[0][k]), words));
    sum1 = hn::Add(sum1, hn::TableLookupBytes(hn::LoadDup128(d, rows.of[1][k]), words));
    sum2 = hn::Add(sum2, hn::TableLookupBytes(hn::LoadDup128(d, rows.of[2][k]), words));
    sum3 = hn::Add(sum3, hn::TableLookupBytes(hn::LoadDup128(d, rows.of[3][k]), words));
  }
  return hn::Min(hn::Min(sum0, sum1), hn::Min(sum2, sum3));
}

/// How many of `count` bytes are `value`; count is a multiple of the vector's bytes, at most 255 of
/// them.
HWY_ATTR std::uint64_t count_equal(const std::uint8_t* bytes, std::size_t count,
                                   std::uint8_t value) {
  const Bytes d;
  const ByteVector wanted = hn::Set(d, value);
  ByteVector hits = hn::Zero(d);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    // True is all ones, which is -1.
    hits = hn::Sub(hits, hn::VecFromMask(d, hn::Eq(hn::Load(d, bytes + i), wanted)));
  }
  const hn::Repartition<std::uint64_t, Bytes> wide;
  return hn::GetLane(hn::SumOfLanes(wide, hn::SumsOf8(hits)));
}

/// Adds the distances of blocks first .. end - 1, at most kBlocksCounted of them.
HWY_ATTR void add_few_blocks(const NibblePlanes& planes, std::size_t first, std::size_t end,
                             const ProbeRows& rows, DistanceHistogram& histogram) {
  constexpr std::size_t kWords = NibblePlanes::kBlockWords;
  const Bytes d;
  const std::size_t lanes = hn::Lanes(d);
  HWY_ALIGN std::uint8_t least[kBlocksCounted * kWords];
  HWY_ALIGN std::uint8_t extremes[2 * kWords];
  ByteVector low = hn::Set(d, std::uint8_t{255});
  ByteVector high = hn::Zero(d);
  std::size_t words = 0;
  for (std::size_t block = first; block < end; ++block) {
    for (std::size_t lane = 0; lane < kWords; lane += lanes, words += lanes) {
      const ByteVector found = least_of_four(planes.block(block) + lane, rows, planes.nibbles());
      hn::Store(found, d, least + words);
      low = hn::Min(low, found);
      high = hn::Max(high, found);
    }
  }
  hn::Store(low, d, extremes);
  hn::Store(high, d, extremes + kWords);
  const int lowest = *std::min_element(extremes, extremes + lanes);
  const int highest = *std::max_element(extremes + kWords, extremes + kWords + lanes);
  for (int distance = lowest; distance <= highest; ++distance) {
    histogram[static_cast<std::size_t>(distance)] +=
        count_equal(least, words, static_cast<std::uint8_t>(distance));
  }
}

#endif  // HWY_TARGET == HWY_SCALAR

HWY_ATTR void add_blocks(const NibblePlanes& planes, std::size_t first, std::size_t end,
                         const FourTurns& probes, DistanceHistogram& histogram) {
  const ProbeRows rows = rows_of(probes, planes.nibbles());
  for (; first < end; first += kBlocksCounted) {
    add_few_blocks(planes, first, std::min(first + kBlocksCounted, end), rows, histogram);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::codec
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::codec {
namespace {

HWY_EXPORT(add_blocks);

}  // namespace

NibblePlanes::NibblePlanes(std::span<const Codeword> words, int bits)
    : nibbles_((bits + 3) / 4),
      blocks_(words.size() / kBlockWords),
      nibbles_of_blocks_(blocks_ * static_cast<std::size_t>(nibbles_) * kBlockWords) {
  std::uint8_t* next = nibbles_of_blocks_.data();
  for (std::size_t block = 0; block < blocks_; ++block) {
    for (int k = nibbles_ - 1; k >= 0; --k) {
      for (const Codeword word : words.subspan(block * kBlockWords, kBlockWords)) {
        *next++ = static_cast<std::uint8_t>(word >> (4 * k) & 15);
      }
    }
  }
}

void add_block_distances(const NibblePlanes& planes, std::size_t first, std::size_t end,
                         const FourTurns& probes, DistanceHistogram& histogram) {
  if (first < end) HWY_DYNAMIC_DISPATCH(add_blocks)(planes, first, end, probes, histogram);
}

}  // namespace tagmint::codec
#endif  // HWY_ONCE
