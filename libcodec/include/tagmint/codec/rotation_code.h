#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/export.h"
#include "tagmint/codec/linear_map.h"

namespace tagmint::codec {

/// A part of a rotation code that is closed under quarter turns by itself: the sums of the first
/// `dimension` words of the basis in the first `cosets` cosets.
struct TAGMINT_API RotationCodeLevel {
  int dimension = 0;
  std::size_t cosets = 1;
  friend bool operator==(const RotationCodeLevel&, const RotationCodeLevel&) = default;
};

/// What a RotationCode is made of; the arguments of its constructor by name.
struct TAGMINT_API RotationCodeParts {
  /// Bits of a word, 1 to 64; bits % 4 is 0 or 1.
  int bits = 0;
  /// Independent words. The first `dimension` of them span a level.
  std::vector<Codeword> basis = {};
  /// XORed on every word.
  Codeword translation = 0;
  /// One representative a coset of the span of the basis, each in another coset.
  std::vector<Codeword> cosets = {0};
  /// Smallest first, each inside the next; the last is the whole code. Empty = one level, the whole
  /// code.
  std::vector<RotationCodeLevel> levels = {};
  friend bool operator==(const RotationCodeParts&, const RotationCodeParts&) = default;
};

/// A set of words that quarter turns map to itself, given by a few words instead of a list:
///
///     { translation ^ coset ^ sum : coset one of the cosets, sum of some words of the basis }
///
/// Its *tags* are the orbits of four different words; a word that a half turn maps to itself is
/// none. Each word has an *address*; words, addresses and turns are found from one another by table
/// look-ups. Constant once made; share it between threads through SharedRotationCode.
class TAGMINT_API RotationCode {
 public:
  /// coset << dimension() | message, where message bit i = basis[i] is part of the sum.
  using Address = std::uint64_t;

  /// Most words that a code may have.
  static constexpr std::uint64_t kMostWords = std::uint64_t{1} << 30;

  /// Throws std::invalid_argument for bits that no layout has, a word with more bits, dependent
  /// words in the basis, two representatives of one coset, more than kMostWords words, levels that
  /// do not grow up to the whole code, and a level that is not closed under turns; the message
  /// names the word or the level.
  ///   cost   microseconds for some cosets; O(cosets * levels * dimension^2)
  explicit RotationCode(RotationCodeParts parts);

  int bits() const { return parts_.bits; }
  /// Words of the basis.
  int dimension() const { return static_cast<int>(parts_.basis.size()); }
  std::span<const Codeword> basis() const { return parts_.basis; }
  Codeword translation() const { return parts_.translation; }
  std::span<const Codeword> cosets() const { return parts_.cosets; }
  /// At least one; the last is the whole code.
  std::span<const RotationCodeLevel> levels() const { return parts_.levels; }

  /// The word at an address below words(). Cost: one look-up for 8 words of the basis.
  Codeword word(Address address) const {
    return shifts_[address >> dimension()] ^ encode_(address & low_mask(dimension()));
  }

  /// The address of `word` as it stands; nothing where it is no word of the code. Cost: some ten
  /// look-ups, and one in a hash table of the cosets.
  std::optional<Address> find(Codeword word) const;

  /// The address of rotate_quarter(word(address)).
  Address turned(Address address) const {
    const CosetTurn& turn = coset_turns_[address >> dimension()];
    return turn.coset << dimension() | (turn_(address & low_mask(dimension())) ^ turn.message);
  }

  /// Words of the whole code; of one level, by its index in levels().
  std::uint64_t words() const { return words(parts_.levels.size() - 1); }
  std::uint64_t words(std::size_t level) const {
    return std::uint64_t{parts_.levels[level].cosets} << parts_.levels[level].dimension;
  }
  /// Tags of the whole code; of one level, those of the levels inside it included. Exact.
  std::size_t tags() const { return tags_.back(); }
  std::size_t tags(std::size_t level) const { return tags_[level]; }

 private:
  /// Where a quarter turn takes a coset: the address of the turned first word of the coset, in
  /// parts.
  struct CosetTurn {
    std::uint64_t coset = 0;
    std::uint64_t message = 0;
  };
  /// A coset's number and the message of its representative.
  struct CosetPlace {
    std::uint64_t coset = 0;
    std::uint64_t message = 0;
  };

  void number_cosets();
  void turn_basis();
  void turn_cosets();
  std::size_t count_tags(const RotationCodeLevel& level) const;

  RotationCodeParts parts_;
  std::vector<Codeword> shifts_;  // translation ^ coset
  LinearMap encode_;              // message -> sum of the basis
  LinearMap message_;             // word -> message; the rest is the word's coset
  std::vector<Codeword> turned_;  // messages of the turned words of the basis
  LinearMap turn_;                // message -> message of the turned sum
  std::vector<CosetTurn> coset_turns_;
  std::unordered_map<Codeword, CosetPlace> coset_of_rest_;
  std::vector<std::size_t> tags_;  // by level
};

using SharedRotationCode = std::shared_ptr<const RotationCode>;

}  // namespace tagmint::codec
