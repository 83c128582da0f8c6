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
  /// Pieces of work in a round: at least `fewest`, at most `most`. Time alone makes no round
  /// shorter than `worthwhile`: on a machine that is busy with other things even the shortest
  /// takes long, while a piece costs the more the shorter the round. A round that takes far too
  /// long is an exception.
  RoundPacer(std::uint64_t fewest, std::uint64_t worthwhile, std::uint64_t most)
      : fewest_(fewest), worthwhile_(worthwhile), most_(most), pieces_(fewest) {}

  std::uint64_t pieces() const { return pieces_; }

  /// The last round took so long and should have taken `longest` at most; `in_vain`: shorter rounds
  /// would have saved work.
  void learn(std::chrono::duration<double> elapsed, std::chrono::duration<double> longest,
             bool in_vain = false) {
    constexpr double kFarTooLong = 5;  // not a busy machine, but work that grows with the round
    if (in_vain || elapsed > kFarTooLong * longest) {
      pieces_ = std::max(pieces_ / 2, fewest_);
    } else if (pieces_ < worthwhile_ || elapsed < longest / 2) {
      pieces_ = std::min(pieces_ * 2, most_);
    } else if (elapsed > longest) {
      pieces_ = std::max(pieces_ / 2, worthwhile_);
    }
  }

 private:
  std::uint64_t fewest_;
  std::uint64_t worthwhile_;
  std::uint64_t most_;
  std::uint64_t pieces_;
};

}  // namespace tagmint::codec
