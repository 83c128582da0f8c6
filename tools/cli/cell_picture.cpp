#include "cli/cell_picture.h"

#include <string_view>

namespace tagmint::cli {
namespace {

std::string_view glyphs(codec::Cell cell) {
  switch (cell) {
    case codec::Cell::White:
      return "\u2588\u2588";
    case codec::Cell::None:
      return "\u00b7\u00b7";
    default:
      return "  ";
  }
}

}  // namespace

std::string cell_picture(const codec::TagCells& cells) {
  std::string text;
  for (int y = 0; y < cells.width(); ++y) {
    for (int x = 0; x < cells.width(); ++x) text += glyphs(cells.at(x, y));
    text += '\n';
  }
  return text;
}

}  // namespace tagmint::cli
