#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/complexity.h"
#include "tagmint/codec/layout.h"
#include "tagmint/codec/tag_id.h"

namespace tagmint::codec {

/// A prefix of the id list that is a code of its own: the first `codes` ids are `min_hamming`
/// apart.
struct Level {
  std::size_t codes = 0;
  int min_hamming = 0;
  friend bool operator==(const Level&, const Level&) = default;
};

/// How a family was made; free text, as family files carry it. Empty strings where it is not known.
struct Origin {
  std::string method;    ///< "lexicode"
  std::string order;     ///< "apriltag2", "apriltag3", "seed:N"
  std::string seed;      ///< decimal seed of the walk
  std::string searched;  ///< "complete", or how many words of the walk
  std::string program;   ///< "tagmint 0.1.0"
  friend bool operator==(const Origin&, const Origin&) = default;
};

/// What a Family is made of; the arguments of its constructor by name.
struct FamilyParts {
  std::string name;
  Layout layout;
  int min_hamming = 0;
  std::vector<Codeword> codewords;  ///< in id order
  Complexity complexity;
  Origin origin;
  std::vector<Level> levels;  ///< largest distance first; empty = one level, the whole family
};

/// A set of tags that share a layout and are `min_hamming` apart in every rotation. Constant once
/// made, cheap to share through std::shared_ptr<const Family> between any number of threads.
class Family {
 public:
  /// Throws std::invalid_argument when the name is empty or holds other characters than letters,
  /// digits, '_', '-', '.'; the distance is outside 1..bits; there is no codeword; a codeword has
  /// more bits than the layout or occurs twice; the levels do not grow in size and fall in distance
  /// down to the whole family. Distances are declared here and proven by check_family().
  explicit Family(FamilyParts parts);

  const std::string& name() const { return parts_.name; }
  const Layout& layout() const { return parts_.layout; }
  int bits() const { return parts_.layout.bits(); }
  std::size_t size() const { return parts_.codewords.size(); }
  Codeword codeword(TagId id) const { return parts_.codewords[id]; }
  std::span<const Codeword> codewords() const { return parts_.codewords; }

  /// Declared minimum Hamming distance over all pairs, rotations and self-rotations.
  int min_hamming() const { return parts_.min_hamming; }
  /// Bit errors that are always corrected to the right tag: floor((min_hamming - 1) / 2).
  int max_safe_errors() const { return (parts_.min_hamming - 1) / 2; }
  const Complexity& complexity() const { return parts_.complexity; }
  const Origin& origin() const { return parts_.origin; }
  /// At least one; the last is the whole family.
  std::span<const Level> levels() const { return parts_.levels; }

 private:
  FamilyParts parts_;
};

using SharedFamily = std::shared_ptr<const Family>;

}  // namespace tagmint::codec
