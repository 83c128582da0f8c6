#include "published_table.h"

#include "tagmint/codec/rotation.h"

namespace tagmint::bench {

PublishedTable::PublishedTable(const codec::Family& family) : bits_(family.bits()) {
  const auto n = static_cast<std::size_t>(bits_);
  slots_.resize(3 * family.size() * (1 + n + n * (n - 1)));
  for (codec::TagId id = 0; id < family.size(); ++id) {
    const codec::Codeword word = family.codeword(id);
    insert(word, id, 0);
    for (int i = 0; i < bits_; ++i) {
      const codec::Codeword one = word ^ codec::Codeword{1} << i;
      insert(one, id, 1);
      for (int j = 0; j < i; ++j) insert(one ^ codec::Codeword{1} << j, id, 2);
    }
  }
}

std::optional<codec::Match> PublishedTable::decode(codec::Codeword observed) const {
  for (int turns = 0; turns < 4; ++turns, observed = codec::rotate_quarter(observed, bits_)) {
    for (std::size_t slot = slot_of(observed); slots_[slot].word != ~std::uint64_t{0};
         slot = slot + 1 == slots_.size() ? 0 : slot + 1) {
      if (slots_[slot].word == observed) {
        return codec::Match{slots_[slot].id, slots_[slot].hamming, turns};
      }
    }
  }
  return std::nullopt;
}

void PublishedTable::insert(std::uint64_t word, codec::TagId id, int hamming) {
  std::size_t slot = slot_of(word);
  while (slots_[slot].word != ~std::uint64_t{0}) slot = slot + 1 == slots_.size() ? 0 : slot + 1;
  slots_[slot] = {word, static_cast<std::uint16_t>(id), static_cast<std::uint8_t>(hamming), 0};
}

/// The fraction word / 2^64 of the table, of a mixed word: faster than a remainder.
std::size_t PublishedTable::slot_of(std::uint64_t word) const {
  __extension__ using Wide = unsigned __int128;
  word ^= word >> 31;
  word *= 0x9e3779b97f4a7c15u;
  word ^= word >> 29;
  return static_cast<std::size_t>((Wide{word} * slots_.size()) >> 64);
}

}  // namespace tagmint::bench
