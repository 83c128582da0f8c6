#include "support/generated_families.h"

#include <memory>
#include <vector>

#include "support/rotation_codes.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::test {
namespace {

codec::SharedRotationCode code_of(codec::RotationCodeParts parts) {
  return std::make_shared<const codec::RotationCode>(std::move(parts));
}

}  // namespace

codec::FamilyParts generated_36() {
  return {.name = "generated36",
          .layout = codec::classic_layout(10),
          .min_hamming = 8,
          .codewords = {},
          .complexity = {codec::ComplexityRule::Energy, 0.3333},
          .origin = {"rotation-code", "", "", "", "test"},
          .levels = {{60, 16, 0}, {2016, 12, 132}, {8128, 10, 465}, {130816, 8, 9119}},
          .generator = code_of(chain_of_36_bits())};
}

codec::FamilyParts generated_25() {
  return {.name = "generated25",
          .layout = codec::classic_layout(9),
          .min_hamming = 9,
          .codewords = {},
          .complexity = {},
          .origin = {},
          .levels = {},
          .generator = code_of(coset_of_25_bits())};
}

codec::FamilyParts generated_16() {
  return {.name = "generated16",
          .layout = codec::classic_layout(8),
          .min_hamming = 5,
          .codewords = {},
          .complexity = {},
          .origin = {},
          .levels = {{4, 6}, {16, 5}},
          .generator = code_of(cosets_of_16_bits())};
}

codec::Family listed(const codec::Family& family) {
  return codec::Family({.name = family.name(),
                        .layout = family.layout(),
                        .min_hamming = family.min_hamming(),
                        .codewords = codec::first_codewords(family, family.size()),
                        .complexity = family.complexity(),
                        .origin = family.origin(),
                        .levels = {family.levels().begin(), family.levels().end()}});
}

}  // namespace tagmint::test
