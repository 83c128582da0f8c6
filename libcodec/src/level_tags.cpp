#include "level_tags.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "colour_changes.h"
#include "kernels/orbit_kernels.h"
#include "tagmint/codec/linear_map.h"

namespace tagmint::codec {
namespace {

using Address = RotationCode::Address;

constexpr std::uint64_t kBlock = 64;  // addresses that are looked at together
constexpr int kBlockBits = 6;

ChangeBits operator^(const ChangeBits& a, const ChangeBits& b) {
  ChangeBits sum;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = a[i] ^ b[i];
  return sum;
}

/// The address turned once, twice and three times.
std::array<std::uint32_t, 3> three_turns(const RotationCode& code, Address address) {
  std::array<std::uint32_t, 3> turns;
  for (std::uint32_t& turned : turns) {
    address = code.turned(address);
    turned = static_cast<std::uint32_t>(address);
  }
  return turns;
}

/// Colour changes of the words of a code from their addresses: linear maps of the message.
class MessageChanges {
 public:
  MessageChanges(const RotationCode& code, const ColourChanges& changes)
      : code_(code), changes_(changes) {
    const ChangeBits none = changes.change_bits(0);
    for (std::size_t word = 0; word < maps_.size(); ++word) {
      std::vector<Codeword> columns;
      for (const Codeword basis : code.basis()) {
        columns.push_back((changes.change_bits(basis) ^ none)[word]);
      }
      maps_[word] = LinearMap(columns);
    }
  }

  /// What the message adds to the changes of its coset's first word.
  ChangeBits of_message(std::uint64_t message) const {
    ChangeBits bits;
    for (std::size_t word = 0; word < maps_.size(); ++word) bits[word] = maps_[word](message);
    return bits;
  }

  /// The changes of a coset's first word.
  ChangeBits of_coset(std::uint64_t coset) const {
    return changes_.change_bits(code_.word(coset << code_.dimension()));
  }

 private:
  const RotationCode& code_;
  const ColourChanges& changes_;
  std::array<LinearMap, 4> maps_;
};

/// Walks through the addresses of a level, 64 at a time.
class LevelWalk {
 public:
  LevelWalk(const RotationCode& code, std::size_t level, const Layout& layout,
            const Complexity& rule)
      : code_(code),
        level_(code.levels()[level]),
        inner_(level > 0 ? code.levels()[level - 1] : RotationCodeLevel{0, 0}),
        places_(code, level),
        rule_(rule),
        judge_(layout, rule),
        colours_(layout),
        changes_(code, colours_),
        // The judge compares with a real number; the least whole number that reaches it does the
        // same.
        least_changes_(static_cast<int>(std::ceil(rule.threshold * 2 * colours_.cells())) -
                       colours_.fixed_changes()),
        accepted_(places_.size() / kBlock),
        plain_(places_.size() / kBlock) {
    const auto zero = three_turns(code, 0);
    for (std::uint32_t low = 0; low < kBlock; ++low) {
      const Address message = low & low_mask(code.dimension());
      const auto turned = three_turns(code, message);
      for (int turn = 0; turn < 3; ++turn) {
        low_.turned[turn][low] = turned[turn] ^ zero[turn];
      }
      low_.changes[low] = changes_.of_message(message);
    }
  }

  LevelTags run() {
    for (std::uint64_t coset = 0; coset < level_.cosets; ++coset) walk_coset(coset);
    return {RankedBits(std::move(accepted_)), RankedBits(std::move(plain_))};
  }

 private:
  /// Messages of the coset that the level before does not have.
  void walk_coset(std::uint64_t coset) {
    const Address start = coset << code_.dimension();
    // No word of a coset that a turn takes to an earlier one is the first of its orbit.
    for (const Address turned : three_turns(code_, start)) {
      if (turned >> code_.dimension() < coset) return;
    }
    const std::uint64_t begin =
        coset < inner_.cosets ? std::uint64_t{1} << inner_.dimension : std::uint64_t{0};
    const std::uint64_t end = std::uint64_t{1} << level_.dimension;
    const ChangeBits coset_changes = changes_.of_coset(coset);
    for (std::uint64_t block = begin / kBlock * kBlock; block < end; block += kBlock) {
      std::uint64_t own = end - block >= kBlock ? ~std::uint64_t{0} : low_mask(end - block);
      if (block < begin) own &= ~low_mask(begin - block);
      const HighAddress high{static_cast<std::uint32_t>(start | block),
                             three_turns(code_, start | block),
                             coset_changes ^ changes_.of_message(block)};
      const std::uint64_t tags = own & smallest_of_orbit(low_, high);
      const std::uint64_t accepted = pass(tags, high);
      const std::size_t word = places_.place(start | block) / kBlock;
      accepted_[word] = accepted;
      plain_[word] = tags & ~accepted;
    }
  }

  /// Those of the tags in a block that pass the rule.
  std::uint64_t pass(std::uint64_t tags, const HighAddress& high) const {
    if (rule_.rule == ComplexityRule::None) return tags;
    if (rule_.rule == ComplexityRule::Energy) {
      return with_changes(tags, low_, high, least_changes_);
    }
    std::uint64_t accepted = 0;
    for (std::uint64_t rest = tags; rest != 0; rest &= rest - 1) {
      const int low = std::countr_zero(rest);
      const bool passes = judge_.accepts(code_.word(high.address | static_cast<Address>(low)));
      accepted |= std::uint64_t{passes} << low;
    }
    return accepted;
  }

  const RotationCode& code_;
  RotationCodeLevel level_;
  RotationCodeLevel inner_;  // the level before
  LevelPlaces places_;
  Complexity rule_;
  ComplexityJudge judge_;
  ColourChanges colours_;
  MessageChanges changes_;
  int least_changes_;
  LowAddresses low_;
  std::vector<std::uint64_t> accepted_;
  std::vector<std::uint64_t> plain_;
};

}  // namespace

LevelPlaces::LevelPlaces(const RotationCode& code, std::size_t level)
    : dimension_(code.dimension()),
      coset_shift_(std::max(code.levels()[level].dimension, kBlockBits)),
      cosets_(code.levels()[level].cosets),
      messages_(std::uint64_t{1} << code.levels()[level].dimension) {}

LevelTags find_level_tags(const RotationCode& code, std::size_t level, const Layout& layout,
                          const Complexity& rule) {
  return LevelWalk(code, level, layout, rule).run();
}

}  // namespace tagmint::codec
