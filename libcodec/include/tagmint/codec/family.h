#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/complexity.h"
#include "tagmint/codec/export.h"
#include "tagmint/codec/layout.h"
#include "tagmint/codec/rotation_code.h"
#include "tagmint/codec/tag_id.h"
#include "tagmint/codec/tag_index.h"

namespace tagmint::codec {

/// A prefix of the id list that is a code of its own: the first `codes` ids are `min_hamming`
/// apart.
struct TAGMINT_API Level {
  std::size_t codes = 0;
  int min_hamming = 0;
  /// How many of the ids that the level adds to the one before it fail the family's complexity
  /// rule; they are the last of them.
  std::size_t plain = 0;
  friend bool operator==(const Level&, const Level&) = default;
};

/// How a family was made; free text, as family files carry it. Empty strings where it is not known.
struct TAGMINT_API Origin {
  std::string method;    ///< "lexicode", "rotation-code"
  std::string order;     ///< "apriltag2", "apriltag3", "seed:N"
  std::string seed;      ///< decimal seed of the walk
  std::string searched;  ///< "complete", or how many words of the walk
  std::string program;   ///< "tagmint 0.1.0"
  friend bool operator==(const Origin&, const Origin&) = default;
};

/// What a Family is made of; the arguments of its constructor by name.
struct TAGMINT_API FamilyParts {
  std::string name;
  Layout layout;
  int min_hamming = 0;
  std::vector<Codeword> codewords;  ///< in id order; empty where there is a generator
  Complexity complexity;
  Origin origin;
  std::vector<Level> levels;  ///< largest distance first; empty = one level, the whole family
  /// Instead of codewords: the code whose tags are those of the family, in the order of TagIndex.
  /// `levels` are then its levels.
  SharedRotationCode generator = nullptr;
  /// With a generator: family_digest() as the family's file tells it; empty where nobody told.
  /// Believed here, proven by check_family().
  std::string declared_digest = {};
};

/// A set of tags that share a layout and are `min_hamming` apart in every rotation. Constant once
/// made, cheap to share through std::shared_ptr<const Family> between any number of threads.
///
/// Its codewords are *listed* one by one, or *generated* by a rotation code that may have millions
/// of tags. codeword() and size() serve both.
class TAGMINT_API Family {
 public:
  /// Throws std::invalid_argument when the name is empty or holds other characters than letters,
  /// digits, '_', '-', '.'; the distance is outside 1..bits; there are no codewords and no
  /// generator, or both; a codeword has more bits than the layout or occurs twice; the generator
  /// has other bits, no tags or other levels; the levels do not grow in size and fall in distance
  /// down to the whole family, or have more plain tags than tags. Distances and plain tags are
  /// declared here and proven by check_family().
  explicit Family(FamilyParts parts);

  const std::string& name() const { return parts_.name; }
  const Layout& layout() const { return parts_.layout; }
  int bits() const { return parts_.layout.bits(); }
  std::size_t size() const { return parts_.levels.back().codes; }
  /// The codeword of a tag; id < size(). Cost: O(1); TagIndex::codeword() where generated.
  Codeword codeword(TagId id) const {
    return is_listed() ? parts_.codewords[id] : index_->codeword(id);
  }

  /// Whether the codewords are listed: there is no generator.
  bool is_listed() const { return index_ == nullptr; }
  /// All codewords in id order, of a listed family only; some_codewords() serves all families.
  std::span<const Codeword> codewords() const {
    assert(is_listed());
    return parts_.codewords;
  }
  /// The code that makes the codewords; null where they are listed.
  const SharedRotationCode& generator() const { return parts_.generator; }
  /// Ids of words and words of ids of a generated family, shared by its copies; null where listed.
  const SharedTagIndex& index() const { return index_; }
  /// FamilyParts::declared_digest.
  const std::string& declared_digest() const { return parts_.declared_digest; }

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
  SharedTagIndex index_;
};

using SharedFamily = std::shared_ptr<const Family>;

/// The codewords of the ids from `first` on, at most `count` of them, in id order.
/// Cost: some nanoseconds a codeword.
TAGMINT_API std::vector<Codeword> some_codewords(const Family& family, TagId first,
                                                 std::size_t count);

/// The codewords of the first ids, at most `count` of them, in id order.
TAGMINT_API std::vector<Codeword> first_codewords(const Family& family, std::size_t count);

/// The first `codes` tags as a family of listed codewords, with the levels that they reach into.
///   codes   1 to family.size()
TAGMINT_API Family first_tags(const Family& family, std::size_t codes);

}  // namespace tagmint::codec
