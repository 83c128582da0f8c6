#include "search/turn_blocks.h"

#include <algorithm>

namespace tagmint::codec {

void TurnBlocks::add(std::span<const Codeword, 4> turns) {
  if (full_ == blocks_.size()) {
    blocks_.emplace_back();
    std::copy(turns.begin(), turns.end(), blocks_.back().words.begin());
  } else {
    ++full_;
  }
  std::copy(turns.begin(), turns.end(), blocks_.back().words.begin() + 4);
}

}  // namespace tagmint::codec
