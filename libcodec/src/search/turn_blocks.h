#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// The accepted codes of a search as the filter reads them: each code's four turns side by side,
/// two codes to a block of 64 bytes. Blocks may change places, so that those that often exclude a
/// word come to be asked first.
class TurnBlocks {
 public:
  static constexpr std::size_t kWords = 8;
  struct alignas(64) Block {
    std::array<Codeword, kWords> words;
  };

  /// Adds the four turns of one code. The last block holds it twice until another code comes.
  void add(std::span<const Codeword, 4> turns);
  void clear() {
    blocks_.clear();
    full_ = 0;
  }

  Block* data() { return blocks_.data(); }
  const Block* data() const { return blocks_.data(); }
  std::size_t size() const { return blocks_.size(); }
  /// Blocks that hold two codes; they come first and only they may change places.
  std::size_t full() const { return full_; }

 private:
  std::vector<Block> blocks_;
  std::size_t full_ = 0;
};

}  // namespace tagmint::codec
