#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tagmint/codec/decoder.h"

/// The hash table of the AprilTag 2 paper, section III-E, in the size that libapriltag 3.3 gives
/// it: each word within two errors of a codeword has an entry of 16 bytes, with the word, its id,
/// its errors and its turns; the four turns of an observed word are looked up one after another
/// until one is found. The library offers no look-up of single words, so that its table is timed by
/// this one. Its heap grows by three slots for each codeword and each *ordered* pair of errors,
/// twice as many as there are words, and so does this table; decoder_bench prints both sizes.
namespace tagmint::bench {

class PublishedTable {
 public:
  explicit PublishedTable(const codec::Family& family);

  std::optional<codec::Match> decode(codec::Codeword observed) const;

  std::size_t bytes() const { return slots_.size() * sizeof(Slot); }

 private:
  struct Slot {
    std::uint64_t word = ~std::uint64_t{0};
    std::uint16_t id = 0;
    std::uint8_t hamming = 0;
    std::uint8_t rotation = 0;
  };

  void insert(std::uint64_t word, codec::TagId id, int hamming);
  std::size_t slot_of(std::uint64_t word) const;

  int bits_;
  std::vector<Slot> slots_;
};

}  // namespace tagmint::bench
