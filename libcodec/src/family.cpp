#include "tagmint/codec/family.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include "family_rules.h"

namespace tagmint::codec {

Family::Family(FamilyParts parts) : parts_(std::move(parts)) {
  check_family_name(parts_.name);
  check_min_hamming(parts_.min_hamming, bits());
  if (parts_.codewords.empty()) {
    throw std::invalid_argument("a family needs at least one codeword");
  }
  if (parts_.codewords.size() > std::numeric_limits<TagId>::max()) {
    throw std::invalid_argument(
        fmt::format("{} codewords are more than ids can count", parts_.codewords.size()));
  }
  if (const auto fault = find_codeword_fault(parts_.codewords, bits())) {
    throw std::invalid_argument(fault->message);
  }
  if (parts_.levels.empty()) parts_.levels = {{parts_.codewords.size(), parts_.min_hamming}};
  check_levels(parts_.levels, parts_.codewords.size(), parts_.min_hamming);
}

}  // namespace tagmint::codec
