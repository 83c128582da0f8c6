#include "kernels/start_kernels.h"

#include <array>

// Highway compiles this file once for each set of instructions.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/start_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::detect {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Words = hn::CappedTag<std::uint64_t, 8>;
using WordVector = hn::Vec<Words>;

static_assert(kStartDepth == 5, "one vector is held for each row but the last");

/// The runs of black in a row, for spreading bits along them.
struct Row {
  WordVector black;
  WordVector pairs;  ///< black with black to the right of it
  WordVector fours;  ///< followed by three more

  WordVector cut;  ///< first and last bits of words where the run goes on in the next word

  HWY_ATTR Row(WordVector v, const std::uint64_t* from) : black(v) {
    const Words d;
    pairs = hn::And(v, hn::ShiftRight<1>(v));
    fours = hn::And(pairs, hn::ShiftRight<2>(pairs));
    const auto before = hn::ShiftRight<63>(hn::LoadU(d, from - 1));
    const auto after = hn::ShiftLeft<63>(hn::LoadU(d, from + 1));
    cut = hn::And(hn::Or(before, after), v);
  }

  /// Black pixels that a path may reach from `below`, bits of the row below: a step up, then along
  /// the run, any number of pixels to the right and seven to the left. Runs that touch a word's
  /// edge are reached from outside.
  HWY_ATTR WordVector reached(WordVector below) const {
    auto seeds = hn::Or(hn::And(below, black), cut);
    seeds = hn::Or(seeds, hn::And(black, hn::ShiftRight<1>(seeds)));
    seeds = hn::Or(seeds, hn::And(pairs, hn::ShiftRight<2>(seeds)));
    seeds = hn::Or(seeds, hn::And(fours, hn::ShiftRight<4>(seeds)));
    // Adding a run's seeds to it carries through all its bits from the first seed on.
    return hn::Or(seeds, hn::AndNot(hn::Add(black, seeds), black));
  }
};

/// Last pixels of the runs that are all in `clear` and have a pixel in `deep`.
HWY_ATTR WordVector starts_of(WordVector black, WordVector clear, WordVector deep) {
  const Words d;
  // Adding a run's first bit to its bits that are clear carries out of the run if all are; adding
  // its deep bits to the run if there are any. What carries out of the word is its last bit.
  const auto firsts = hn::AndNot(hn::ShiftLeft<1>(black), black);
  const auto clear_sum = hn::Add(clear, firsts);
  const auto deep_sum = hn::Add(black, deep);
  const auto inside = hn::ShiftRight<1>(hn::AndNot(black, hn::And(clear_sum, deep_sum)));
  const auto top = hn::Set(d, 0x8000000000000000u);
  const auto out_of_clear = hn::VecFromMask(d, hn::Lt(clear_sum, clear));
  const auto out_of_deep = hn::VecFromMask(d, hn::Lt(deep_sum, black));
  return hn::Or(inside, hn::And(top, hn::And(out_of_clear, out_of_deep)));
}

/// One column of vectors, from the lowest row up.
HWY_ATTR void find_starts_in_column(BitBlock black, int rows, std::uint64_t* starts,
                                    std::ptrdiff_t starts_stride) {
  const Words d;
  const auto zero = hn::Zero(d);
  // pathN: pixels of the row below with a path over N rows.
  auto path1 = zero, path2 = zero, path3 = zero, path4 = zero;
  auto here = hn::LoadU(d, black.first + (rows + kStartDepth - 2) * black.stride);
  for (int y = rows + kStartDepth - 2; y >= 0; --y) {
    const auto above = hn::LoadU(d, black.first + (y - 1) * black.stride);
    auto found = zero;
    if (!hn::AllTrue(d, hn::Eq(here, zero))) {
      const Row row(here, black.first + y * black.stride);
      const auto deep = row.reached(path4);
      path4 = row.reached(path3);
      path3 = row.reached(path2);
      path2 = row.reached(path1);
      path1 = here;
      found = starts_of(here, hn::AndNot(above, here), deep);
    } else {
      path1 = path2 = path3 = path4 = zero;
    }
    if (y < rows) hn::StoreU(found, d, starts + y * starts_stride);
    here = above;
  }
}

HWY_ATTR void find_starts(BitBlock black, int rows, int words, std::uint64_t* starts,
                          std::ptrdiff_t starts_stride) {
  for (int w = 0; w < words; w += static_cast<int>(hn::Lanes(Words()))) {
    find_starts_in_column({black.first + w, black.stride}, rows, starts + w, starts_stride);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::detect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::detect {
namespace scalar {
namespace {

constexpr std::uint64_t kFirstBit = 1;

/// `seeds` and all black pixels that lie in a run with them, up to seven to the left.
std::uint64_t along_runs(std::uint64_t black, std::uint64_t seeds) {
  std::uint64_t reached = seeds;
  for (int step = 0; step < 7; ++step) reached |= reached >> 1 & black;
  for (int step = 0; step < 64; ++step) reached |= reached << 1 & black;
  return reached;
}

/// Black pixels of the word at `from` that a path may reach from `below`.
std::uint64_t reached(const std::uint64_t* from, std::uint64_t below) {
  const std::uint64_t cut = (from[-1] >> 63) | (from[1] << 63);
  return along_runs(*from, (below | cut) & *from);
}

/// Bit for bit over the runs of a word.
std::uint64_t starts_of(std::uint64_t black, std::uint64_t above, std::uint64_t deep) {
  std::uint64_t found = 0;
  bool is_clear = true;
  bool is_deep = false;
  for (int i = 0; i < 64; ++i) {
    const std::uint64_t bit = kFirstBit << i;
    if (!(black & bit)) {
      is_clear = true;
      is_deep = false;
      continue;
    }
    is_clear = is_clear && !(above & bit);
    is_deep = is_deep || (deep & bit);
    const bool last = i == 63 || !(black & bit << 1);
    if (last && is_clear && is_deep) found |= bit;
  }
  return found;
}

}  // namespace

void find_starts(BitBlock black, int rows, int words, std::uint64_t* starts,
                 std::ptrdiff_t starts_stride) {
  for (int w = 0; w < words; ++w) {
    std::array<std::uint64_t, kStartDepth - 1> paths{};  // paths[i]: over i + 1 rows
    for (int y = rows + kStartDepth - 2; y >= 0; --y) {
      const std::uint64_t* here = black.first + y * black.stride + w;
      const std::uint64_t above = black.first[(y - 1) * black.stride + w];
      const std::uint64_t deep = reached(here, paths.back());
      for (std::size_t i = paths.size() - 1; i > 0; --i) paths[i] = reached(here, paths[i - 1]);
      paths[0] = *here;
      if (y < rows) starts[y * starts_stride + w] = starts_of(*here, above, deep);
    }
  }
}

}  // namespace scalar

HWY_EXPORT(find_starts);

void find_starts(BitBlock black, int rows, int words, std::uint64_t* starts,
                 std::ptrdiff_t starts_stride) {
  HWY_DYNAMIC_DISPATCH(find_starts)(black, rows, words, starts, starts_stride);
}

}  // namespace tagmint::detect
#endif
