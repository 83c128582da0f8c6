#pragma once

#include <utility>
#include <vector>

#include "tagmint/codec/complexity.h"
#include "tagmint/codec/family.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::testing {

/// Whether a family could take the word as one more tag: by the definition.
inline bool could_be_added(const codec::Family& family, codec::Codeword word) {
  const int bits = family.bits();
  if (codec::self_distance(word, bits) < family.min_hamming()) return false;
  for (const codec::Codeword code : family.codewords()) {
    if (codec::rotation_distance(word, code, bits) < family.min_hamming()) return false;
  }
  return codec::ComplexityJudge(family.layout(), family.complexity()).accepts(word);
}

/// The family less the tag `id`.
inline codec::Family without(const codec::Family& family, codec::TagId id) {
  std::vector<codec::Codeword> codewords(family.codewords().begin(), family.codewords().end());
  codewords.erase(codewords.begin() + id);
  return codec::Family({.name = family.name(),
                        .layout = family.layout(),
                        .min_hamming = family.min_hamming(),
                        .codewords = std::move(codewords),
                        .complexity = family.complexity(),
                        .origin = {},
                        .levels = {}});
}

}  // namespace tagmint::testing
