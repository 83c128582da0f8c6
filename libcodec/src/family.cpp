#include "tagmint/codec/family.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <stdexcept>
#include <utility>

#include "family_rules.h"

namespace tagmint::codec {

namespace {

/// What the codewords of a listed family must obey.
void check_codewords(const FamilyParts& parts) {
  if (parts.codewords.empty()) {
    throw std::invalid_argument("a family needs at least one codeword");
  }
  if (parts.codewords.size() > std::numeric_limits<TagId>::max()) {
    throw std::invalid_argument(
        fmt::format("{} codewords are more than ids can count", parts.codewords.size()));
  }
  if (const auto fault = find_codeword_fault(parts.codewords, parts.layout.bits())) {
    throw std::invalid_argument(fault->message);
  }
}

}  // namespace

Family::Family(FamilyParts parts) : parts_(std::move(parts)) {
  check_family_name(parts_.name);
  check_min_hamming(parts_.min_hamming, bits());
  const SharedRotationCode& generator = parts_.generator;
  if (generator == nullptr) {
    check_codewords(parts_);
  } else if (!parts_.codewords.empty()) {
    throw std::invalid_argument("a family has codewords or a generator, not both");
  }
  const std::size_t size = generator ? generator->tags() : parts_.codewords.size();
  if (parts_.levels.empty()) parts_.levels = {{size, parts_.min_hamming}};
  if (generator != nullptr) {
    check_generator(*generator, parts_.layout.bits(), parts_.levels);
    index_ = std::make_shared<const TagIndex>(generator, parts_.layout, parts_.complexity);
  }
  check_levels(parts_.levels, size, parts_.min_hamming);
}

std::vector<Codeword> some_codewords(const Family& family, TagId first, std::size_t count) {
  const std::size_t left = family.size() - std::min<std::size_t>(first, family.size());
  count = std::min(count, left);
  if (!family.is_listed()) return family.index()->codewords(first, count);
  const auto begin = family.codewords().begin() + first;
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

std::vector<Codeword> first_codewords(const Family& family, std::size_t count) {
  return some_codewords(family, 0, count);
}

Family first_tags(const Family& family, std::size_t codes) {
  assert(codes >= 1 && codes <= family.size());
  FamilyParts parts{.name = family.name(),
                    .layout = family.layout(),
                    .min_hamming = 0,
                    .codewords = first_codewords(family, codes),
                    .complexity = family.complexity(),
                    .origin = family.origin(),
                    .levels = {}};
  for (Level level : family.levels()) {
    const std::size_t first_plain = level.codes - level.plain;
    level.codes = std::min(level.codes, codes);
    level.plain = level.codes - std::min(level.codes, first_plain);
    parts.levels.push_back(level);
    if (level.codes == codes) break;
  }
  parts.min_hamming = parts.levels.back().min_hamming;
  return Family(std::move(parts));
}

}  // namespace tagmint::codec
