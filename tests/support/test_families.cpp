#include "support/test_families.h"

#include <string>
#include <utility>

#include "tagmint/codec/layout_presets.h"

namespace tagmint::test {

codec::SharedFamily arbitrary_family(std::string_view layout_name, std::size_t size) {
  codec::FamilyParts parts{.name = "arbitrary",
                           .layout = codec::parse_layout(layout_name),
                           .min_hamming = 1,
                           .codewords = {},
                           .complexity = {},
                           .origin = {},
                           .levels = {}};
  const codec::Codeword mask = codec::low_mask(parts.layout.bits());
  // An odd multiplier: the words of all indexes differ.
  for (std::size_t i = 0; i < size; ++i) {
    parts.codewords.push_back((i * 0x2545f4914f6cdd1dULL + 0x5a17) & mask);
  }
  return std::make_shared<const codec::Family>(std::move(parts));
}

}  // namespace tagmint::test
