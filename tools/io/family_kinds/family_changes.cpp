#include "io/family_kinds/family_changes.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace tagmint::io {
namespace {

using codec::Family;
using codec::FamilyParts;

FamilyParts parts_of(const Family& family) {
  FamilyParts parts{.name = family.name(),
                    .layout = family.layout(),
                    .min_hamming = family.min_hamming(),
                    .codewords = {},
                    .complexity = family.complexity(),
                    .origin = family.origin(),
                    .levels = {family.levels().begin(), family.levels().end()},
                    .generator = family.generator(),
                    .declared_digest = family.declared_digest()};
  if (family.is_listed()) {
    parts.codewords.assign(family.codewords().begin(), family.codewords().end());
  }
  return parts;
}

}  // namespace

Family renamed(const Family& family, const std::string& name) {
  FamilyParts parts = parts_of(family);
  parts.name = name;
  return Family(std::move(parts));
}

Family with_options(Family family, const FamilyReadOptions& options) {
  const char* const refused = options.layout                                ? "--layout"
                              : options.min_hamming                         ? "--min-hamming"
                              : options.bit_order != BitOrder::AsRecognised ? "--bit-order"
                                                                            : nullptr;
  if (refused) {
    throw std::invalid_argument(std::string("a tagmint family says all of itself; leave ") +
                                refused + " out");
  }
  if (options.name.empty() || options.name == family.name()) return family;
  return renamed(family, options.name);
}

Family first_tags(const Family& family, std::size_t codes) {
  FamilyParts parts = parts_of(family);
  parts.codewords = codec::first_codewords(family, codes);
  parts.generator = nullptr;
  parts.declared_digest.clear();
  parts.levels.clear();
  for (codec::Level level : family.levels()) {
    const bool last = level.codes >= codes;
    if (last) {
      // The plain tags of a level are its last ones.
      level.plain -= std::min(level.plain, level.codes - codes);
      level.codes = codes;
    }
    parts.levels.push_back(level);
    if (last) break;
  }
  parts.min_hamming = parts.levels.back().min_hamming;
  return Family(std::move(parts));
}

}  // namespace tagmint::io
