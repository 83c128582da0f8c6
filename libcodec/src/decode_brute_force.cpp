#include "decode_lookup.h"

namespace tagmint::codec {
namespace {

class BruteForceLookup final : public ListLookup {
 public:
  BruteForceLookup(const TagList& tags, int radius) : ListLookup(tags, radius) {}

  std::optional<Match> decode(Codeword observed) const override {
    const FourTurns turned = four_turns(observed, bits());
    Nearest nearest;
    for (std::size_t i = 0; i < codewords().size(); ++i) {
      for (const Codeword word : turned) compare(word, i, nearest);
    }
    return answer(turned, nearest);
  }

  std::size_t table_bytes() const override { return 0; }
};

}  // namespace

std::unique_ptr<const Decoder::Lookup> make_brute_force_lookup(const TagList& tags, int radius) {
  return std::make_unique<const BruteForceLookup>(tags, radius);
}

}  // namespace tagmint::codec
