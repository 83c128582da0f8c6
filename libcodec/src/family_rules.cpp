#include "family_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace tagmint::codec {

void check_family_name(const std::string& name) {
  constexpr std::string_view allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  if (name.empty() || name.find_first_not_of(allowed) != std::string::npos) {
    throw std::invalid_argument(fmt::format(
        "family name '{}' is not possible; use letters, digits, '_', '-' and '.'", name));
  }
}

void check_min_hamming(int min_hamming, int bits) {
  if (min_hamming < 1 || min_hamming > bits) {
    throw std::invalid_argument(
        fmt::format("minimum Hamming distance {} is not possible with {} bits; 1 to {} are",
                    min_hamming, bits, bits));
  }
}

std::optional<CodewordFault> find_codeword_fault(std::span<const Codeword> codewords, int bits) {
  for (std::size_t id = 0; id < codewords.size(); ++id) {
    if ((codewords[id] & ~low_mask(bits)) != 0) {
      return CodewordFault{id, fmt::format("codeword {} ({}) has more than the layout's {} bits",
                                           id, to_hex(codewords[id]), bits)};
    }
  }
  // Ids sorted by codeword, equal ones by id: repetitions stand behind their first occurrence.
  std::vector<std::size_t> order(codewords.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return codewords[a] != codewords[b] ? codewords[a] < codewords[b] : a < b;
  });
  std::optional<CodewordFault> fault;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::size_t first = order[i - 1];
    const std::size_t second = order[i];
    if (codewords[first] != codewords[second] || (fault && fault->id <= second)) continue;
    fault = {second, fmt::format("codewords {} and {} are the same ({})", first, second,
                                 to_hex(codewords[second]))};
  }
  return fault;
}

void check_levels(std::span<const Level> levels, std::size_t size, int min_hamming) {
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    if (levels[i].codes >= levels[i + 1].codes ||
        levels[i].min_hamming <= levels[i + 1].min_hamming) {
      throw std::invalid_argument(fmt::format(
          "level {} must have more codes and a smaller distance than level {}", i + 1, i));
    }
  }
  if (levels.empty() || levels.front().codes == 0 || levels.back() != Level{size, min_hamming}) {
    throw std::invalid_argument(fmt::format(
        "the last level must be the whole family: {} codes at distance {}", size, min_hamming));
  }
}

}  // namespace tagmint::codec
