#pragma once

#include <span>
#include <vector>

#include "search/rotation/random_choice.h"
#include "tagmint/codec/codeword.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {

/// By how much a quarter turn changes a word. Linear, and four times in a row it gives 0: turn - 1
/// is nilpotent over GF(2), since (turn - 1)^4 = turn^4 - 1.
constexpr Codeword turn_difference(Codeword word, int bits) {
  return word ^ rotate_quarter(word, bits);
}

/// A linear code that quarter turns map to itself. It grows by one dimension at a time, and every
/// such code can be grown so: as turn - 1 is nilpotent, each has a chain of closed codes inside.
class TurnCode {
 public:
  /// The code that holds the word 0 alone.
  explicit TurnCode(int bits) : bits_(bits) {}

  int bits() const { return bits_; }
  int dimension() const { return static_cast<int>(rows_.size()); }
  /// The words as they were added: each prefix spans a closed code.
  std::span<const Codeword> basis() const { return basis_; }
  /// A basis in reduced echelon form, largest word first.
  std::span<const Codeword> rows() const { return rows_; }

  /// The least of the words that differ from `word` by a word of the code.
  Codeword reduce(Codeword word) const {
    for (const Codeword row : rows_) word = std::min(word, word ^ row);
    return word;
  }
  bool contains(Codeword word) const { return reduce(word) == 0; }

  /// Adds the sums with `word`, which must not be in the code while its turn_difference() is.
  void extend(Codeword word);

  /// Adds `words` and all their turns.
  void adjoin(std::span<const Codeword> words);

  /// The first `dimension` words of the basis.
  TurnCode prefix(int dimension) const;

 private:
  void insert(Codeword word);

  int bits_;
  std::vector<Codeword> basis_;
  std::vector<Codeword> rows_;
};

/// Words, each in another class modulo `code`, whose sums are all the ways to grow `code` by one
/// dimension: word ^ turn(word) is in the code. With `inside`, which must contain `code`, the words
/// are in that code. At most bits / 4 + 1 of them.
std::vector<Codeword> one_step_extensions(const TurnCode& code, const TurnCode* inside);

/// A random closed code of `dimension` between `keep` and `code`.
TurnCode random_subcode(const TurnCode& code, const TurnCode& keep, int dimension,
                        RandomChoice& random);

}  // namespace tagmint::codec
