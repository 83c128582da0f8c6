#include "cli/html/tag_svg.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "cli/html/markup.h"
#include "draw/tag_outline.h"

namespace tagmint::cli {
namespace {

using codec::Cell;

/// Outlines as path data. Every outline begins with a step to the right, so its points lie
/// alternately across and up or down from each other.
std::string path_of(const std::vector<draw::Outline>& outlines) {
  std::string path;
  for (const draw::Outline& outline : outlines) {
    path += fmt::format("M{} {}", outline.front().x, outline.front().y);
    for (std::size_t i = 1; i < outline.size(); ++i) {
      path += i % 2 == 1 ? fmt::format("H{}", outline[i].x) : fmt::format("V{}", outline[i].y);
    }
    path += 'z';
  }
  return path;
}

}  // namespace

std::string black_path(const codec::TagCells& cells) {
  return path_of(draw::black_outlines(cells));
}

std::string blank_path(const codec::Layout& layout) {
  std::vector<Cell> blanks;
  for (int y = 0; y < layout.width(); ++y) {
    for (int x = 0; x < layout.width(); ++x) {
      blanks.push_back(layout.cell(x, y) == Cell::None ? Cell::Black : Cell::White);
    }
  }
  return black_path(codec::TagCells(layout.width(), std::move(blanks)));
}

std::string tag_svg(const codec::Family& family, codec::TagId id) {
  const int side = family.layout().width() + 2;
  const std::string blank = blank_path(family.layout());
  return fmt::format(
      "<svg viewBox=\"-1 -1 {0} {0}\" class=\"tag\" role=\"img\"><title>{1} id {2}</title>"
      "<path class=\"paper\" d=\"M-1-1h{0}v{0}h-{0}z\"></path>{3}"
      "<path class=\"ink\" d=\"{4}\"></path></svg>",
      side, escaped(family.name()), id,
      blank.empty() ? "" : fmt::format("<path class=\"blank\" d=\"{}\"></path>", blank),
      black_path(codec::tag_cells(family.layout(), family.codeword(id))));
}

}  // namespace tagmint::cli
