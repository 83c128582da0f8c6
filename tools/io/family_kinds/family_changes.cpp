#include "io/family_kinds/family_changes.h"

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

}  // namespace tagmint::io
