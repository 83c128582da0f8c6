// docs/examples/layouts.cpp: a layout of one's own, with a hole in the middle.
#include <iostream>
#include <stdexcept>

#include "tagmint/codec/layout.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/search/lexicode.h"
#include "tagmint/codec/tag_cells.h"

namespace codec = tagmint::codec;

int main() {
  // d = data, b = black, w = white, x = nothing is printed: here another tag may stand.
  const codec::Layout layout(
      "wwwwwwwww/"
      "wbbbbbbbw/"
      "wbdddddbw/"
      "wbdddddbw/"
      "wbddxddbw/"
      "wbdddddbw/"
      "wbdddddbw/"
      "wbbbbbbbw/"
      "wwwwwwwww");
  std::cout << layout.bits() << " data cells, " << layout.width_at_border() << " of "
            << layout.width() << " cells at the border\n";

  codec::LexicodeOptions search{.layout = layout, .min_hamming = 10};
  search.limit_codes = 12;
  const codec::Family family = codec::make_family(search, codec::search_lexicode(search));
  std::cout << family.name() << ": " << family.size() << " tags\n";
  for (const std::string& row : codec::tag_cells(layout, family.codeword(0)).rows()) {
    std::cout << row << '\n';
  }

  // What cannot be a layout is refused with the reason.
  try {
    codec::parse_layout("custom:wwwww/wbbbw/wbdbw/wbdbw/wwwww");
  } catch (const std::invalid_argument& complaint) {
    std::cout << complaint.what() << '\n';
  }
}
