#include "tagmint/codec/family.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace tagmint::codec {
namespace {

void check_name(const std::string& name) {
  constexpr std::string_view allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  if (name.empty() || name.find_first_not_of(allowed) != std::string::npos) {
    throw std::invalid_argument(fmt::format(
        "family name '{}' is not possible; use letters, digits, '_', '-' and '.'", name));
  }
}

void check_codewords(const std::vector<Codeword>& codewords, int bits) {
  if (codewords.empty()) throw std::invalid_argument("a family needs at least one codeword");
  if (codewords.size() > std::numeric_limits<TagId>::max()) {
    throw std::invalid_argument(
        fmt::format("{} codewords are more than ids can count", codewords.size()));
  }
  for (std::size_t id = 0; id < codewords.size(); ++id) {
    if ((codewords[id] & ~low_mask(bits)) != 0) {
      throw std::invalid_argument(fmt::format("codeword {} ({}) has more than the layout's {} bits",
                                              id, to_hex(codewords[id]), bits));
    }
  }
  std::vector<Codeword> sorted = codewords;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    const auto first = std::find(codewords.begin(), codewords.end(), *twice);
    const auto second = std::find(first + 1, codewords.end(), *twice);
    throw std::invalid_argument(fmt::format("codewords {} and {} are the same ({})",
                                            first - codewords.begin(), second - codewords.begin(),
                                            to_hex(*twice)));
  }
}

void check_levels(const std::vector<Level>& levels, std::size_t size, int min_hamming) {
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    if (levels[i].codes >= levels[i + 1].codes ||
        levels[i].min_hamming <= levels[i + 1].min_hamming) {
      throw std::invalid_argument(fmt::format(
          "level {} must have more codes and a smaller distance than level {}", i + 1, i));
    }
  }
  if (levels.front().codes == 0 || levels.back() != Level{size, min_hamming}) {
    throw std::invalid_argument(fmt::format(
        "the last level must be the whole family: {} codes at distance {}", size, min_hamming));
  }
}

}  // namespace

Family::Family(FamilyParts parts) : parts_(std::move(parts)) {
  check_name(parts_.name);
  const int bits = parts_.layout.bits();
  if (parts_.min_hamming < 1 || parts_.min_hamming > bits) {
    throw std::invalid_argument(
        fmt::format("minimum Hamming distance {} is not possible with {} bits; 1 to {} are",
                    parts_.min_hamming, bits, bits));
  }
  check_codewords(parts_.codewords, bits);
  if (parts_.levels.empty()) parts_.levels = {{parts_.codewords.size(), parts_.min_hamming}};
  check_levels(parts_.levels, parts_.codewords.size(), parts_.min_hamming);
}

}  // namespace tagmint::codec
