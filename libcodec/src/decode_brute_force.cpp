#include "decode_lookup.h"

namespace tagmint::codec {
namespace {

class BruteForceLookup final : public ListLookup {
 public:
  BruteForceLookup(const TagList& tags, int radius) : ListLookup(tags, radius) {}

  std::size_t table_bytes() const override { return 0; }

 private:
  Nearest nearest(Codeword word) const override {
    Nearest nearest;
    for (std::size_t i = 0; i < codewords().size(); ++i) compare(word, i, nearest);
    return nearest;
  }
};

}  // namespace

std::unique_ptr<const Decoder::Lookup> make_brute_force_lookup(const TagList& tags, int radius) {
  return std::make_unique<const BruteForceLookup>(tags, radius);
}

}  // namespace tagmint::codec
