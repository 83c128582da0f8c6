#include "search/sieve_kernels.h"

#include <algorithm>
#include <bit>

#include "tagmint/codec/codeword.h"

#define HWY_WANT_AVX3_DL  // the AVX-512 that counts bits
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "search/sieve_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::codec::sieve_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <typename T>
using TagOf = hn::CappedTag<T, 64 / sizeof(T)>;

/// Codes that the words are compared with before those excluded are dropped: dropping costs as much
/// as some five comparisons, and a word once excluded is compared for nothing.
constexpr std::size_t kCodesBetweenDrops = 32;

/// The smaller of two distances. They fill the low byte of a lane alone, so lanes of 64 bits may be
/// compared as pairs of 32: every machine that has vectors has a minimum for those.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V least(D d, V a, V b) {
#if HWY_TARGET == HWY_SCALAR
  (void)d;
  return hn::Min(a, b);
#else
  const hn::Repartition<std::int32_t, D> halves;
  return hn::BitCast(d, hn::Min(hn::BitCast(halves, a), hn::BitCast(halves, b)));
#endif
}

template <class V>
HWY_INLINE V distance(V word, V code) {
  return hn::PopulationCount(hn::Xor(word, code));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V nearer(D d, V nearest, V word, V code) {
  return least(d, nearest, distance(word, code));
}

/// Stores the lanes whose nearest code is at least `min_hamming` away; returns their number.
template <class D, class V = hn::Vec<D>>
HWY_INLINE std::size_t store_far(D d, V words, V nearest, int min_hamming, std::size_t lanes,
                                 hn::TFromD<D>* out) {
  const hn::RebindToSigned<D> signed_d;
  const auto far = hn::Gt(hn::BitCast(signed_d, nearest), hn::Set(signed_d, min_hamming - 1));
  const auto kept = hn::And(hn::RebindMask(d, far), hn::FirstN(d, lanes));
  return hn::CompressStore(words, kept, d, out);
}

/// Words in lanes, four vectors at a time, each code against all of them.
template <class D, typename T = hn::TFromD<D>>
HWY_INLINE std::size_t drop_near(D d, T* words, std::size_t count, const T* codes,
                                 std::size_t code_count, int min_hamming) {
  const std::size_t lanes = hn::Lanes(d);
  const auto far_off = hn::Set(d, T{kMaxBits + 1});
  std::size_t kept = 0;
  std::size_t i = 0;
  for (; i + 4 * lanes <= count; i += 4 * lanes) {
    const auto word0 = hn::LoadU(d, words + i);
    const auto word1 = hn::LoadU(d, words + i + lanes);
    const auto word2 = hn::LoadU(d, words + i + 2 * lanes);
    const auto word3 = hn::LoadU(d, words + i + 3 * lanes);
    auto nearest0 = far_off;
    auto nearest1 = far_off;
    auto nearest2 = far_off;
    auto nearest3 = far_off;
    for (std::size_t c = 0; c < code_count; ++c) {
      const auto code = hn::Set(d, codes[c]);
      nearest0 = nearer(d, nearest0, word0, code);
      nearest1 = nearer(d, nearest1, word1, code);
      nearest2 = nearer(d, nearest2, word2, code);
      nearest3 = nearer(d, nearest3, word3, code);
    }
    kept += store_far(d, word0, nearest0, min_hamming, lanes, words + kept);
    kept += store_far(d, word1, nearest1, min_hamming, lanes, words + kept);
    kept += store_far(d, word2, nearest2, min_hamming, lanes, words + kept);
    kept += store_far(d, word3, nearest3, min_hamming, lanes, words + kept);
  }
  for (; i < count; i += lanes) {
    const auto word = hn::LoadU(d, words + i);
    auto nearest = far_off;
    std::size_t c = 0;
    for (; c + 4 <= code_count; c += 4) {
      const auto of_two =
          nearer(d, distance(word, hn::Set(d, codes[c])), word, hn::Set(d, codes[c + 1]));
      const auto of_others =
          nearer(d, distance(word, hn::Set(d, codes[c + 2])), word, hn::Set(d, codes[c + 3]));
      nearest = least(d, nearest, least(d, of_two, of_others));
    }
    for (; c < code_count; ++c) nearest = nearer(d, nearest, word, hn::Set(d, codes[c]));
    kept += store_far(d, word, nearest, min_hamming, std::min(lanes, count - i), words + kept);
  }
  return kept;
}

/// Codes in lanes: one word against all of them.
template <class D, typename T = hn::TFromD<D>>
HWY_INLINE bool is_far(D d, T word, const T* codes, std::size_t code_count, int min_hamming) {
  const hn::RebindToSigned<D> signed_d;
  const std::size_t lanes = hn::Lanes(d);
  const auto far_off = hn::Set(d, T{kMaxBits + 1});
  const auto needle = hn::Set(d, word);
  const auto limit = hn::Set(signed_d, min_hamming);
  std::size_t c = 0;
  for (; c + 2 * lanes <= code_count; c += 2 * lanes) {
    auto nearest = nearer(d, far_off, needle, hn::LoadU(d, codes + c));
    nearest = nearer(d, nearest, needle, hn::LoadU(d, codes + c + lanes));
    if (!hn::AllFalse(signed_d, hn::Lt(hn::BitCast(signed_d, nearest), limit))) return false;
  }
  for (; c < code_count; ++c) {
    if (std::popcount(static_cast<T>(word ^ codes[c])) < min_hamming) return false;
  }
  return true;
}

template <typename T>
HWY_INLINE std::size_t keep_far_in_lanes(T* words, std::size_t count, const T* codes,
                                         std::size_t code_count, int min_hamming) {
  const TagOf<T> d;
  std::size_t done = 0;
  while (done < code_count && count >= hn::Lanes(d) / 2) {
    const std::size_t step = std::min(kCodesBetweenDrops, code_count - done);
    count = drop_near(d, words, count, codes + done, step, min_hamming);
    done += step;
  }
  if (done == code_count) return count;
  std::size_t kept = 0;  // so few words that lanes would stay empty
  for (std::size_t i = 0; i < count; ++i) {
    const T word = words[i];
    if (is_far(d, word, codes + done, code_count - done, min_hamming)) words[kept++] = word;
  }
  return kept;
}

std::size_t keep_far_32(std::uint32_t* words, std::size_t count, const std::uint32_t* codes,
                        std::size_t code_count, int min_hamming) {
  return keep_far_in_lanes(words, count, codes, code_count, min_hamming);
}

std::size_t keep_far_64(std::uint64_t* words, std::size_t count, const std::uint64_t* codes,
                        std::size_t code_count, int min_hamming) {
  return keep_far_in_lanes(words, count, codes, code_count, min_hamming);
}

void fill_progression_vector(std::uint32_t first, std::uint32_t step, int bits, std::size_t count,
                             std::uint32_t* out) {
  const TagOf<std::uint32_t> d;
  const auto mask = hn::Set(d, static_cast<std::uint32_t>(low_mask(bits)));
  const auto stride = hn::Set(d, step * static_cast<std::uint32_t>(hn::Lanes(d)));
  auto word = hn::Add(hn::Set(d, first), hn::Mul(hn::Iota(d, 0), hn::Set(d, step)));
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    hn::StoreU(hn::And(word, mask), d, out + i);
    word = hn::Add(word, stride);
  }
}

/// Most cells hold fewer codes than a vector has lanes, so a whole vector is copied from each and
/// what is too much is overwritten by the next: no branch depends on the number of codes.
std::size_t gather_cells_vector(const std::uint32_t* HWY_RESTRICT starts,
                                const std::uint32_t* HWY_RESTRICT codes, std::uint32_t key,
                                const std::uint32_t* HWY_RESTRICT masks, std::size_t mask_count,
                                std::uint32_t* HWY_RESTRICT out) {
  const TagOf<std::uint32_t> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t total = 0;
  for (std::size_t i = 0; i < mask_count; ++i) {
    const std::uint32_t cell = key ^ masks[i];
    const std::uint32_t start = starts[cell];
    const std::size_t size = starts[cell + 1] - start;
    hn::StoreU(hn::LoadU(d, codes + start), d, out + total);
    for (std::size_t j = lanes; j < size; j += lanes) {
      hn::StoreU(hn::LoadU(d, codes + start + j), d, out + total + j);
    }
    total += size;
  }
  return total;
}

}  // namespace tagmint::codec::sieve_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::codec::sieve_kernels {
namespace {

template <typename T>
std::size_t keep_far_plainly(T* words, std::size_t count, const T* codes, std::size_t code_count,
                             int min_hamming) {
  const auto is_near = [&](T word) {
    return std::any_of(codes, codes + code_count, [&](T code) {
      return std::popcount(static_cast<T>(word ^ code)) < min_hamming;
    });
  };
  return static_cast<std::size_t>(std::remove_if(words, words + count, is_near) - words);
}

}  // namespace

HWY_EXPORT(fill_progression_vector);
HWY_EXPORT(keep_far_32);
HWY_EXPORT(keep_far_64);
HWY_EXPORT(gather_cells_vector);

void fill_progression(std::uint32_t first, std::uint32_t step, int bits, std::size_t count,
                      std::uint32_t* out) {
  HWY_DYNAMIC_DISPATCH(fill_progression_vector)(first, step, bits, count, out);
}

void fill_progression_scalar(std::uint32_t first, std::uint32_t step, int bits, std::size_t count,
                             std::uint32_t* out) {
  for (std::size_t i = 0; i < count; ++i, first += step) {
    out[i] = first & static_cast<std::uint32_t>(low_mask(bits));
  }
}

std::size_t keep_far(std::uint32_t* words, std::size_t count, const std::uint32_t* codes,
                     std::size_t code_count, int min_hamming) {
  return HWY_DYNAMIC_DISPATCH(keep_far_32)(words, count, codes, code_count, min_hamming);
}

std::size_t keep_far(std::uint64_t* words, std::size_t count, const std::uint64_t* codes,
                     std::size_t code_count, int min_hamming) {
  return HWY_DYNAMIC_DISPATCH(keep_far_64)(words, count, codes, code_count, min_hamming);
}

std::size_t keep_far_scalar(std::uint32_t* words, std::size_t count, const std::uint32_t* codes,
                            std::size_t code_count, int min_hamming) {
  return keep_far_plainly(words, count, codes, code_count, min_hamming);
}

std::size_t keep_far_scalar(std::uint64_t* words, std::size_t count, const std::uint64_t* codes,
                            std::size_t code_count, int min_hamming) {
  return keep_far_plainly(words, count, codes, code_count, min_hamming);
}

std::size_t gather_cells(const std::uint32_t* starts, const std::uint32_t* codes, std::uint32_t key,
                         const std::uint32_t* masks, std::size_t mask_count, std::uint32_t* out) {
  return HWY_DYNAMIC_DISPATCH(gather_cells_vector)(starts, codes, key, masks, mask_count, out);
}

std::size_t gather_cells_scalar(const std::uint32_t* starts, const std::uint32_t* codes,
                                std::uint32_t key, const std::uint32_t* masks,
                                std::size_t mask_count, std::uint32_t* out) {
  std::size_t total = 0;
  for (std::size_t i = 0; i < mask_count; ++i) {
    const std::uint32_t cell = key ^ masks[i];
    std::copy(codes + starts[cell], codes + starts[cell + 1], out + total);
    total += starts[cell + 1] - starts[cell];
  }
  return total;
}

}  // namespace tagmint::codec::sieve_kernels
#endif  // HWY_ONCE
