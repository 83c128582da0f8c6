// The word is cut into chunks. If it has few errors, some chunks have none: whichever codeword it
// came from agrees with it there. So the codewords by these chunks give all candidates, and the
// distance of each decides.
//
// Up to two errors the chunks are the four blocks of a word, which quarter turns exchange:
//
//     word   [ a | b | c | d | centre ]
//
// Two errors leave two blocks intact, either neighbours (ab, bc, cd or da) or opposite ones (ac or
// bd). One index of all turns of all codewords by their first two blocks serves the four pairs of
// neighbours, since bc, cd and da come first after one, two and three turns; and one by the first
// and third block serves the opposite ones. One error leaves ab or cd intact. As all turns are in
// the index, the word is found whichever way it is turned. Two blocks are half of the word: few
// random words agree with a codeword there, and the filters of the indices refuse nearly all.
//
// For more errors the word is cut into one chunk more than there are errors, and each chunk is
// looked up in each turn.

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "cell_index.h"
#include "decode_lookup.h"

namespace tagmint::codec {
namespace {

/// The turns of an observed word that are looked up: 0, step, 2 * step ..
struct LookedUp {
  unsigned turns = 0;
  unsigned step = 1;
};

struct TurnedIndex {
  CellIndex index;
  LookedUp looked_up;
};

class ChunkLookup final : public ListLookup {
 public:
  ChunkLookup(const TagList& tags, int radius) : ListLookup(tags, radius) {
    const int block = tags.bits / 4;
    const int second = tags.bits - 2 * block;  // the lowest bit of the second block
    const int third = second - block;
    const CellMask first_two{second, low_mask(2 * block)};
    const CellMask first_and_third{third, low_mask(block) << 2 * block | low_mask(block)};
    if (radius == 0) {
      add(tags, 4, {0, low_mask(tags.bits)}, {.turns = 1});
    } else if (radius == 1) {
      add(tags, 4, first_two, {.turns = 2, .step = 2});
    } else if (radius == 2) {
      add(tags, 4, first_two, {.turns = 4});
      add(tags, 4, first_and_third, {.turns = 2});
    } else {
      // Chunks of equal width, give or take one. With radius == bits the first is empty: it agrees
      // with everything, and a word may indeed differ from its codeword in every bit.
      const int chunks = radius + 1;
      for (int chunk = 0; chunk < chunks; ++chunk) {
        const int begin = chunk * tags.bits / chunks;
        const int end = (chunk + 1) * tags.bits / chunks;
        add(tags, 1, {begin, low_mask(end - begin)}, {.turns = 4});
      }
    }
  }

  std::optional<Match> decode(Codeword observed) const override {
    const FourTurns turned = four_turns(observed, bits());
    Nearest nearest;
    for (const TurnedIndex& one : indices_) {
      switch (one.looked_up.turns) {
        case 4:
          look_up<4>(one, turned, nearest);
          break;
        case 2:
          look_up<2>(one, turned, nearest);
          break;
        default:
          look_up<1>(one, turned, nearest);
      }
    }
    return answer(turned, nearest);
  }

  std::size_t table_bytes() const override {
    std::size_t bytes = 0;
    for (const TurnedIndex& one : indices_) bytes += one.index.bytes();
    return bytes;
  }

 private:
  void add(const TagList& tags, int stored_turns, const CellMask& cells, LookedUp looked_up) {
    indices_.push_back({CellIndex(tags.codewords, tags.bits, stored_turns, cells), looked_up});
  }

  /// `kTurns` is one.looked_up.turns: known to the compiler, so that it lays them side by side.
  template <unsigned kTurns>
  void look_up(const TurnedIndex& one, const FourTurns& turned, Nearest& nearest) const {
    // All turns are filtered before the first entry is read, so that the memory is asked for all at
    // once.
    const unsigned step = one.looked_up.step;
    std::array<CellIndex::Place, kTurns> places{};
    unsigned held = 0;
    for (unsigned i = 0; i < kTurns; ++i) {
      places[i] = one.index.place(turned[i * step]);
      held |= one.index.may_hold(places[i]) << i;
    }
    for (; held != 0; held &= held - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(held));
      for (const CellIndex::Entry entry : one.index.entries(places[i])) {
        // The codeword turned so often is looked for near this turn of the observed word.
        compare(turned[(i * step - entry) & 3], entry >> 2, nearest);
      }
    }
  }

  std::vector<TurnedIndex> indices_;
};

}  // namespace

std::unique_ptr<const Decoder::Lookup> make_chunk_lookup(const TagList& tags, int radius) {
  return std::make_unique<const ChunkLookup>(tags, radius);
}

}  // namespace tagmint::codec
