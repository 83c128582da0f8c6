// docs/examples/cells.cpp: all tags of a family, cell by cell, as a program that converts or draws
// them needs them. Writes the file of one tag as a portable graymap on the standard output.
#include <iostream>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/tag_cells.h"

namespace codec = tagmint::codec;

int main() {
  const codec::SharedFamily family = codec::find_family("tag16h5");
  const codec::Layout& layout = family->layout();

  // tag_cells() is the one description that drawing, rendering and tests use.
  std::size_t black = 0;
  for (codec::TagId id = 0; id < family->size(); ++id) {
    const codec::TagCells cells = codec::tag_cells(layout, family->codeword(id));
    for (int y = 0; y < cells.width(); ++y) {
      for (int x = 0; x < cells.width(); ++x) black += cells.at(x, y) == codec::Cell::Black;
    }
    // And back: the codeword whose picture this is.
    if (codec::codeword_of(layout, cells) != family->codeword(id)) return 1;
  }
  std::cerr << black << " black cells in " << family->size() << " tags\n";

  const codec::TagCells first = codec::tag_cells(layout, family->codeword(0));
  std::cout << "P2 " << first.width() << ' ' << first.width() << " 1\n";
  for (const std::string& row : first.rows()) {
    for (const char cell : row) std::cout << (cell == 'b' ? "0 " : "1 ");
    std::cout << '\n';
  }
}
