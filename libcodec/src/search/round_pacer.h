#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace tagmint::codec {

/// Chooses how much work the next round takes: little while most of it is in vain, then more, but
/// never so much that a round keeps a stop or a progress report waiting. The search's result does
/// not depend on it.
class RoundPacer {
 public:
  /// `fewest` and `most` pieces of work in a round that should last `longest`.
  RoundPacer(std::uint64_t fewest, std::uint64_t most, std::chrono::duration<double> longest)
      : fewest_(fewest), most_(most), longest_(longest), pieces_(fewest) {}

  std::uint64_t pieces() const { return pieces_; }

  /// The last round took so long; `in_vain`: shorter rounds would have saved work.
  void learn(std::chrono::duration<double> elapsed, bool in_vain = false) {
    if (in_vain || elapsed > longest_) {
      pieces_ = std::max(pieces_ / 2, fewest_);
    } else if (elapsed < longest_ / 2) {
      pieces_ = std::min(pieces_ * 2, most_);
    }
  }

 private:
  std::uint64_t fewest_;
  std::uint64_t most_;
  std::chrono::duration<double> longest_;
  std::uint64_t pieces_;
};

}  // namespace tagmint::codec
