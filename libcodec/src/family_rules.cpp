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

void check_generator(const RotationCode& generator, int bits, std::span<const Level> levels) {
  if (generator.bits() != bits) {
    throw std::invalid_argument(
        fmt::format("the generator makes words of {} bits, the layout has {} data cells",
                    generator.bits(), bits));
  }
  if (generator.levels().size() != levels.size()) {
    throw std::invalid_argument(fmt::format("the family has {} levels, its generator {}",
                                            levels.size(), generator.levels().size()));
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::size_t tags = generator.tags(i);
    if (tags == 0) {
      throw std::invalid_argument(fmt::format("level {} of the generator has no tags", i));
    }
    if (levels[i].codes != tags) {
      throw std::invalid_argument(
          fmt::format("level {} has {} codes, the generator makes {}", i, levels[i].codes, tags));
    }
  }
}

void check_levels(std::span<const Level> levels, std::size_t size, int min_hamming) {
  std::size_t before = 0;  // codes of the level before
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Level& level = levels[i];
    if (i > 0 && (level.codes <= before || level.min_hamming >= levels[i - 1].min_hamming)) {
      throw std::invalid_argument(fmt::format(
          "level {} must have more codes and a smaller distance than level {}", i, i - 1));
    }
    if (level.plain > level.codes - before) {
      throw std::invalid_argument(fmt::format("level {} has {} plain tags, but adds only {} tags",
                                              i, level.plain, level.codes - before));
    }
    before = level.codes;
  }
  if (levels.empty() || levels.front().codes == 0 || levels.back().codes != size ||
      levels.back().min_hamming != min_hamming) {
    throw std::invalid_argument(fmt::format(
        "the last level must be the whole family: {} codes at distance {}", size, min_hamming));
  }
}

}  // namespace tagmint::codec
