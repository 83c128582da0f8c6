// Every word within two errors of a codeword has an entry in a hash table, so that a word is found
// by looking at one place [WangOlson2016, III-E]. A word and its turns are the same entry, that of
// the least of them, so that one place serves all four turns.
//
// The table is open: an entry stands at its word's hash or in one of the slots after it, with empty
// slots as ends. An entry is only the index of the codeword and its turns. Whether it belongs to
// the word that is looked up follows from the distance between the two, so neither the words nor
// the errors are stored, which makes the table smaller. An entry of another word that stands in the
// way does no harm: if its codeword is within the radius, it is a true answer as well.

#include <cassert>
#include <cstdint>
#include <limits>
#include <vector>

#include "decode_lookup.h"

namespace tagmint::codec {
namespace {

/// At most one slot in two is used: a word that is not there costs 2.5 slots on average.
constexpr std::size_t kSlotsPerEntry = 2;

/// Number of words within `radius` <= 2 bits of one word.
std::size_t ball_size(int bits, int radius) {
  const auto n = static_cast<std::size_t>(bits);
  return 1 + (radius >= 1 ? n : 0) + (radius >= 2 ? n * (n - 1) / 2 : 0);
}

/// Calls visit(word) for each word within `radius` <= 2 bits of `centre`.
template <typename Visit>
void visit_ball(Codeword centre, int bits, int radius, const Visit& visit) {
  visit(centre);
  if (radius < 1) return;
  for (int i = 0; i < bits; ++i) {
    const Codeword one_error = centre ^ (Codeword{1} << i);
    visit(one_error);
    if (radius < 2) continue;
    for (int j = i + 1; j < bits; ++j) visit(one_error ^ (Codeword{1} << j));
  }
}

/// The least of four turns, and which one it is.
struct LeastTurn {
  explicit LeastTurn(const FourTurns& turned) : word(turned[0]) {
    for (unsigned turn = 1; turn < 4; ++turn) {
      turns = turned[turn] < word ? turn : turns;
      word = turned[turn] < word ? turned[turn] : word;
    }
  }
  Codeword word;
  unsigned turns = 0;
};

/// A number below `slots` for each word, evenly spread: two rounds of multiplying and folding, then
/// the fraction word / 2^64 of the table.
std::size_t slot_of(Codeword word, std::size_t slots) {
  __extension__ using Wide = unsigned __int128;
  word ^= word >> 31;
  word *= 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio, odd
  word ^= word >> 29;
  word *= 0xbf58476d1ce4e5b9u;  // an odd number with well mixed bits
  return static_cast<std::size_t>((Wide{word} * slots) >> 64);
}

/// `Number`: an unsigned type that counts the codewords' turns, with its largest value to spare.
template <typename Number>
class HashLookup final : public ListLookup {
 public:
  HashLookup(const TagList& tags, int radius)
      : ListLookup(tags, radius),
        slots_(tags.codewords.size() * ball_size(tags.bits, radius) * kSlotsPerEntry, kEmpty) {
    for (std::size_t i = 0; i < tags.codewords.size(); ++i) {
      visit_ball(tags.codewords[i], tags.bits, radius, [&](Codeword word) {
        const LeastTurn least(four_turns(word, tags.bits));
        insert(least.word, static_cast<Number>(4 * i + least.turns));
      });
    }
  }

  std::optional<Match> decode(Codeword observed) const override {
    const FourTurns turned = four_turns(observed, bits());
    const LeastTurn least(turned);
    Nearest nearest;
    for (std::size_t slot = slot_of(least.word, slots_.size()); slots_[slot] != kEmpty;
         slot = after(slot)) {
      // The codeword turned so often is near the least turn of the observed word.
      const Number number = slots_[slot];
      compare(turned[(least.turns - number) & 3], number >> 2, nearest);
    }
    return answer(turned, nearest);
  }

  std::size_t table_bytes() const override { return slots_.size() * sizeof(Number); }

 private:
  static constexpr Number kEmpty = std::numeric_limits<Number>::max();

  std::size_t after(std::size_t slot) const { return slot + 1 == slots_.size() ? 0 : slot + 1; }

  void insert(Codeword word, Number number) {
    std::size_t slot = slot_of(word, slots_.size());
    while (slots_[slot] != kEmpty) slot = after(slot);
    slots_[slot] = number;
  }

  std::vector<Number> slots_;  // 4 * index + turns
};

/// Whether 16 bits count the turns of so many codewords.
bool fits_16_bits(std::size_t codewords) {
  return 4 * codewords <= std::numeric_limits<std::uint16_t>::max();
}

}  // namespace

std::size_t hash_table_bytes(std::size_t codewords, int bits, int radius) {
  const std::size_t slot_bytes =
      fits_16_bits(codewords) ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
  return codewords * ball_size(bits, radius) * kSlotsPerEntry * slot_bytes;
}

std::unique_ptr<const Decoder::Lookup> make_hash_lookup(const TagList& tags, int radius) {
  assert(radius >= 0 && radius <= 2 && !tags.codewords.empty());
  if (fits_16_bits(tags.codewords.size())) {
    return std::make_unique<const HashLookup<std::uint16_t>>(tags, radius);
  }
  return std::make_unique<const HashLookup<std::uint32_t>>(tags, radius);
}

}  // namespace tagmint::codec
