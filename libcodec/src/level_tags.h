#pragma once

#include <cstddef>

#include "ranked_bits.h"
#include "tagmint/codec/complexity.h"
#include "tagmint/codec/layout.h"
#include "tagmint/codec/rotation_code.h"

namespace tagmint::codec {

/// The addresses of one level of a rotation code, put close together: a coset's messages follow
/// one another, and a coset begins at a multiple of 64.
class LevelPlaces {
 public:
  LevelPlaces(const RotationCode& code, std::size_t level);

  /// Whether the level has the address.
  bool holds(RotationCode::Address address) const {
    return address >> dimension_ < cosets_ && (address & low_mask(dimension_)) < messages_;
  }
  std::size_t place(RotationCode::Address address) const {
    return (address >> dimension_) << coset_shift_ | (address & low_mask(dimension_));
  }
  RotationCode::Address address(std::size_t place) const {
    return (place >> coset_shift_) << dimension_ | (place & low_mask(coset_shift_));
  }
  /// Places in all, a multiple of 64.
  std::size_t size() const { return cosets_ << coset_shift_; }

 private:
  int dimension_;           // of the whole code
  int coset_shift_;         // at least 6
  std::uint64_t cosets_;    // of the level
  std::uint64_t messages_;  // of the level
};

/// The tags that one level adds to the one before it, as places (LevelPlaces) of the smallest
/// addresses of their orbits.
struct LevelTags {
  RankedBits accepted;  ///< tags that pass the complexity rule
  RankedBits plain;     ///< the others
};

/// Finds them by looking at each address of the level.
///   cost   some two nanoseconds an address; with the rule `rectangles` microseconds a tag
LevelTags find_level_tags(const RotationCode& code, std::size_t level, const Layout& layout,
                          const Complexity& rule);

}  // namespace tagmint::codec
