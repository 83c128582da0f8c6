#include "board/board_writer.h"

#include <memory>
#include <string_view>

namespace tagmint::board {

std::string board_file(const Board& board, const BoardPage& page, draw::FileKind kind,
                       const draw::FileOptions& options) {
  std::string content;
  const std::unique_ptr<draw::Canvas> canvas =
      draw::make_canvas(kind, options, [&content](std::string_view bytes) { content += bytes; });
  canvas->begin_page(
      {.width_mm = page.width_mm, .height_mm = page.height_mm, .label = "", .bookmarks = {}});
  if (kind == draw::FileKind::Svg) canvas->paint_ground(white_ground(board, page));
  draw_board(*canvas, board, page);
  canvas->end_page();
  canvas->finish();
  return content;
}

}  // namespace tagmint::board
