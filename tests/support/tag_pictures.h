#pragma once

#include "tagmint/codec/family.h"
#include "tagmint/detect/image.h"

namespace tagmint::test {

/// Gray levels of a print, and how much paper is around it.
struct Print {
  int cell_px = 1;
  int quiet_cells = 0;  ///< of `white` around the whole tag; below 0: outer rings cut off
  std::uint8_t black = 0;
  std::uint8_t white = 255;
  std::uint8_t nothing = 255;  ///< of places without a cell
};

/// A tag whose cells are squares of whole pixels.
detect::Image print_tag(const codec::Family& family, codec::TagId id, const Print& print = {});

/// The same for any word of the family's layout.
detect::Image print_word(const codec::Layout& layout, codec::Codeword word,
                         const Print& print = {});

/// Left and right exchanged.
detect::Image mirrored(const detect::Image& picture);
/// Black and white exchanged.
detect::Image inverted(const detect::Image& picture);
/// Turned clockwise as seen by quarter turns.
detect::Image turned(const detect::Image& picture, int quarters);
/// `inner` put into `outer` with its top left pixel at (x, y).
void put(detect::Image& outer, const detect::Image& inner, int x, int y);

}  // namespace tagmint::test
