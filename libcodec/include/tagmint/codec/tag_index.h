#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/complexity.h"
#include "tagmint/codec/export.h"
#include "tagmint/codec/layout.h"
#include "tagmint/codec/rotation_code.h"
#include "tagmint/codec/tag_id.h"

namespace tagmint::codec {

/// The ids of a rotation code's tags, without a list of words.
///
/// A tag is an orbit of four different words; its codeword is that of the smallest address of the
/// orbit. Ids go level by level; the tags that a level adds to the one before it are counted in the
/// order of their addresses, first those that pass the complexity rule, then the plain ones. A
/// level keeps two bits an address and finds the n-th set one and the number of those before an
/// address by counting few words (docs/rotation-codes.md).
///
/// Safe to share between threads. A level's part is made at the first use of one of its ids.
class TAGMINT_API TagIndex {
 public:
  /// Throws std::invalid_argument when the code is null or its words have not the layout's bits.
  TagIndex(SharedRotationCode code, const Layout& layout, const Complexity& rule);
  ~TagIndex();

  const SharedRotationCode& code() const { return code_; }

  /// The codeword of a tag.
  ///   id     below code()->tags()
  ///   cost   well below a microsecond; the first use of a level some nanoseconds an address of it
  Codeword codeword(TagId id) const;

  /// The codewords of `count` ids from `first` on, all below code()->tags(). Cost: some nanoseconds
  /// a codeword.
  std::vector<Codeword> codewords(TagId first, std::size_t count) const;

  /// A word as a turn of a tag's codeword.
  struct Place {
    TagId id = 0;
    int turns = 0;  ///< quarter turns (rotate_quarter) that take the word to the codeword, 0..3
    friend bool operator==(const Place&, const Place&) = default;
  };

  /// The tag that `word` is some turn of; nothing where it is no word of the code or no tag.
  /// Cost: as codeword().
  std::optional<Place> find(Codeword word) const;

  /// How many of the tags that a level adds to the one before it fail the complexity rule.
  std::size_t plain(std::size_t level) const;

  /// Bytes of the index once the tags of a level, and of those inside it, are in use.
  std::size_t table_bytes(std::size_t level) const;

 private:
  struct Level;

  const Level& level(std::size_t number) const;

  SharedRotationCode code_;
  Layout layout_;
  Complexity rule_;
  std::vector<std::unique_ptr<Level>> levels_;
};

using SharedTagIndex = std::shared_ptr<const TagIndex>;

}  // namespace tagmint::codec
