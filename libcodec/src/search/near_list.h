#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// A code turn as a node of the tree sees it: the bits that the tree has still to decide, and the
/// *remaining radius*: how many of them may differ for a word still to be excluded.
///
///     [ radius: 8 bits, signed | undecided bits: 24 ]
using NearEntry = std::uint32_t;

inline constexpr int kNearBits = 24;
inline constexpr NearEntry kNearBitsMask = (NearEntry{1} << kNearBits) - 1;

constexpr NearEntry near_entry(std::uint32_t undecided, int radius) {
  return (undecided & kNearBitsMask) | (static_cast<std::uint32_t>(radius) << kNearBits);
}
constexpr int radius_of(NearEntry entry) {
  return static_cast<std::int32_t>(entry) >> kNearBits;  // arithmetic shift: keeps the sign
}

/// An entry that excludes nothing.
inline constexpr NearEntry kNothing = near_entry(0, -1);

/// Turns of codes in halves, for vectors of 32-bit lanes.
class SplitTurns {
 public:
  explicit SplitTurns(std::span<const Codeword> turns);
  std::size_t size() const { return size_; }
  /// The bits 32..63 and 0..31 of each turn, with room for a vector to read on behind the last.
  const std::uint32_t* upper() const { return upper_.data(); }
  const std::uint32_t* lower() const { return lower_.data(); }

 private:
  std::size_t size_;
  std::vector<std::uint32_t> upper_;
  std::vector<std::uint32_t> lower_;
};

/// The code turns that may still exclude words below a node. Behind the last entry there always is
/// a vector full of entries of radius -1, which exclude nothing, so that loops run over whole
/// vectors.
class NearList {
 public:
  /// Lanes of the widest vector in use: how many entries the loops may read behind the last one.
  static constexpr std::size_t kPadding = 16;

  NearList() : entries_(kPadding, kNothing) {}

  const NearEntry* data() const { return entries_.data(); }
  std::size_t size() const { return size_; }
  void clear() {
    size_ = 0;
    pad();
  }
  void push_back(NearEntry entry);

  /// Adds the entries of `parent` as they are after the tree has decided four more bits: the radius
  /// shrinks by the number of those bits that differ. Entries whose new radius is in least .. most
  /// are added.
  ///   nibble   the decided bits
  ///   shift    their place in the undecided bits of the parent
  ///   least    >= 0
  void append_narrowed(const NearList& parent, unsigned nibble, int shift, int least, int most);

  /// Adds the entries of `source` with a radius in least .. most.
  ///   least    >= 0
  void append_some(const NearList& source, int least, int most);

  /// Parts the entries of `source`: becomes those of a radius, while `larger` becomes those of
  /// larger ones. `larger` may be `source`.
  void take_equal(const NearList& source, int radius, NearList& larger);

  /// Adds those of `turns` that may exclude words of a subtree.
  ///   prefix      the decided bits of the subtree in place, the others 0
  ///   undecided   number of the others, at most kNearBits
  ///   radius      that a turn has for whole words
  void append_reaching(const SplitTurns& turns, Codeword prefix, int undecided, int radius);

  /// Takes away from `words` those that an entry excludes: from which it differs in at most its
  /// radius of the low `bits` bits. Keeps the order.
  void exclude_from(std::vector<std::uint32_t>& words, int bits) const;

 private:
  void pad();
  void make_room(std::size_t more);

  std::vector<NearEntry> entries_;  // at least size_ + kPadding
  std::size_t size_ = 0;
};

/// Kernels of NearList, and the plain loops that they are tested against.
namespace near_kernels {

struct Narrowing {
  NearEntry bits;       ///< the decided bits in place
  NearEntry mask;       ///< which bits those are
  NearEntry least;      ///< near_entry(0, least radius)
  NearEntry too_large;  ///< near_entry(0, greatest radius + 1)
};

/// Writes narrowed entries to `out`, which has room for count + NearList::kPadding; returns their
/// number. `entries` are padded as a NearList's.
std::size_t narrow(const NearEntry* entries, std::size_t count, const Narrowing& narrowing,
                   NearEntry* out);
std::size_t narrow_scalar(const NearEntry* entries, std::size_t count, const Narrowing& narrowing,
                          NearEntry* out);

/// Writes the entries of a radius to `equal`, those of larger ones to `larger`, which may be
/// `entries`. Both have room for count + NearList::kPadding. Returns the two numbers.
struct Parts {
  std::size_t equal;
  std::size_t larger;
};
Parts part(const NearEntry* entries, std::size_t count, int radius, NearEntry* equal,
           NearEntry* larger);
Parts part_scalar(const NearEntry* entries, std::size_t count, int radius, NearEntry* equal,
                  NearEntry* larger);

/// The subtree that entries are made for.
struct Subtree {
  Codeword prefix;  ///< the decided bits in place, the others 0
  NearEntry mask;   ///< the undecided bits
  int radius;       ///< of the turns for whole words
};

/// Writes entries for the turns with a radius left >= 0 to `out`, which has room for turns.size() +
/// NearList::kPadding; returns their number.
std::size_t reach(const SplitTurns& turns, const Subtree& subtree, NearEntry* out);
std::size_t reach_scalar(const SplitTurns& turns, const Subtree& subtree, NearEntry* out);

/// Moves the words that no entry excludes to the front; returns their number.
///   mask   the bits that count
std::size_t keep_open(const NearEntry* entries, std::size_t count, std::span<std::uint32_t> words,
                      NearEntry mask);
std::size_t keep_open_scalar(const NearEntry* entries, std::size_t count,
                             std::span<std::uint32_t> words, NearEntry mask);

}  // namespace near_kernels
}  // namespace tagmint::codec
