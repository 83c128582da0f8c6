#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

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

  /// Whether an entry excludes `word`: differs from its low `bits` bits in at most its radius.
  bool excludes(std::uint32_t word, int bits) const;

 private:
  static constexpr NearEntry kNothing = near_entry(0, -1);
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

bool excludes(const NearEntry* entries, std::size_t count, std::uint32_t word, NearEntry mask);
bool excludes_scalar(const NearEntry* entries, std::size_t count, std::uint32_t word,
                     NearEntry mask);

}  // namespace near_kernels
}  // namespace tagmint::codec
