#include "support/tag_pictures.h"

#include "tagmint/codec/tag_cells.h"

namespace tagmint::test {

using codec::Cell;
using detect::Image;

Image print_word(const codec::Layout& layout, codec::Codeword word, const Print& print) {
  const codec::TagCells cells = codec::tag_cells(layout, word);
  const int seen = cells.width() + 2 * print.quiet_cells;
  Image picture(seen * print.cell_px, seen * print.cell_px, print.white);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const int column = x / print.cell_px - print.quiet_cells;
      const int row = y / print.cell_px - print.quiet_cells;
      if (column < 0 || row < 0 || column >= cells.width() || row >= cells.width()) continue;
      const Cell cell = cells.at(column, row);
      picture.at(x, y) = cell == Cell::Black   ? print.black
                         : cell == Cell::White ? print.white
                                               : print.nothing;
    }
  }
  return picture;
}

Image print_tag(const codec::Family& family, codec::TagId id, const Print& print) {
  return print_word(family.layout(), family.codeword(id), print);
}

Image mirrored(const Image& picture) {
  Image result = picture;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      result.at(x, y) = picture.at(picture.width() - 1 - x, y);
    }
  }
  return result;
}

Image inverted(const Image& picture) {
  Image result = picture;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      result.at(x, y) = static_cast<std::uint8_t>(255 - picture.at(x, y));
    }
  }
  return result;
}

Image turned(const Image& picture, int quarters) {
  Image result = picture;
  for (int i = 0; i < (quarters & 3); ++i) {
    const Image before = std::move(result);
    result = Image(before.height(), before.width());
    for (int y = 0; y < result.height(); ++y) {
      for (int x = 0; x < result.width(); ++x) {
        result.at(x, y) = before.at(y, before.height() - 1 - x);
      }
    }
  }
  return result;
}

void put(Image& outer, const Image& inner, int x, int y) {
  for (int row = 0; row < inner.height(); ++row) {
    for (int column = 0; column < inner.width(); ++column) {
      outer.at(x + column, y + row) = inner.at(column, row);
    }
  }
}

}  // namespace tagmint::test
