#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

#include "search/greedy.h"

namespace tagmint::codec {

/// Chooses how many words the next round takes: few while most words become codes, so that little
/// is sifted in vain; then more, but never so many that a round keeps a stop or a progress report
/// waiting. The search's result does not depend on it.
class RoundPacer {
 public:
  std::uint64_t words() const { return words_; }

  void learn(const Greedy::Round& round, std::chrono::duration<double> elapsed) {
    const bool in_vain = round.overlapping > kOverlapsForFree + round.taken;
    if (in_vain || elapsed > kLongest) {
      words_ = std::max(words_ / 2, kFewest);
    } else if (elapsed < kLongest / 2) {
      words_ = std::min(words_ * 2, kMost);
    }
  }

 private:
  static constexpr std::uint64_t kFewest = 256;
  static constexpr std::uint64_t kMost = std::uint64_t{1} << 26;  // 2 MiB of bookkeeping
  static constexpr std::size_t kOverlapsForFree = 16;
  static constexpr std::chrono::duration<double> kLongest{0.2};

  std::uint64_t words_ = kFewest;
};

}  // namespace tagmint::codec
