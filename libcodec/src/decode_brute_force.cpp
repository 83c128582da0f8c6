#include "decode_lookup.h"

namespace tagmint::codec {
namespace {

class BruteForceLookup final : public Decoder::Lookup {
 public:
  BruteForceLookup(std::span<const Codeword> codewords, int radius) : Lookup(codewords, radius) {}

  Nearest nearest(Codeword word) const override {
    Nearest nearest;
    for (std::size_t i = 0; i < codewords_.size(); ++i) compare(word, i, nearest);
    return nearest;
  }

  std::size_t table_bytes() const override { return 0; }
};

}  // namespace

std::unique_ptr<const Decoder::Lookup> make_brute_force_lookup(std::span<const Codeword> codewords,
                                                               int radius) {
  return std::make_unique<const BruteForceLookup>(codewords, radius);
}

}  // namespace tagmint::codec
