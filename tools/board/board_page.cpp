#include "board/board_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "board/clearance.h"
#include "draw/ruler.h"
#include "draw/sheet_decor.h"
#include "draw/tag_outline.h"
#include "draw/text.h"
#include "draw/units.h"

namespace tagmint::board {
namespace {

using draw::format_mm;
using draw::Path;
using draw::PathPoint;

constexpr double kNoteGray = 0.5;
constexpr double kNoteSizeMm = 2.6;
// The ruler's zero stands this far in, and the notes below it.
constexpr double kNoteInsetMm = 2.4;
constexpr double kBelowNotesMm = 1.0;
// A board as large as its paper fits, however the numbers were rounded.
constexpr double kSlackMm = 1e-3;

double notes_height(const std::vector<std::string>& lines) {
  if (lines.empty()) return 0.0;
  return draw::kNoteGapMm + draw::kRulerDepthMm +
         draw::kNoteLineMm * static_cast<double>(lines.size()) + kBelowNotesMm;
}

void check_margin(double margin_mm) {
  if (!std::isfinite(margin_mm) || margin_mm < 0) {
    throw std::invalid_argument(
        fmt::format("a margin of {} mm cannot be; it is 0 or more", margin_mm));
  }
}

/// From board coordinates to the page.
PathPoint on_page(const Board& board, const BoardPage& page, detect::Point p) {
  return {p.x - board.extent.x_mm + page.board.x_mm, p.y - board.extent.y_mm + page.board.y_mm};
}

/// Outlines in a tag's grid as polygons on the page.
void add_outlines(Path& path, const Board& board, const BoardPage& page, const BoardTag& tag,
                  const std::vector<draw::Outline>& outlines, bool backwards) {
  const double cell = outer_mm(tag) / tag.layout.width();
  const double middle = tag.layout.width() / 2.0;
  for (const draw::Outline& outline : outlines) {
    std::vector<PathPoint> corners;
    for (const codec::CellPosition& corner : outline) {
      corners.push_back(on_page(
          board, page, on_board(tag, {(corner.x - middle) * cell, (corner.y - middle) * cell})));
    }
    if (backwards) std::reverse(corners.begin(), corners.end());
    path.add_polygon(corners);
  }
}

void draw_notes(draw::Canvas& canvas, const BoardPage& page) {
  const draw::Box& area = page.notes;
  const draw::Ink ink{.gray = kNoteGray, .role = draw::Role::Note};
  const draw::Box ruler = {area.x_mm, area.y_mm + draw::kNoteGapMm, area.width_mm,
                           draw::kRulerDepthMm};
  draw::draw_ruler(canvas, ruler, draw::RulerPlace::Lying, kNoteGray);
  double baseline = ruler.bottom_mm() - 0.8;
  for (const std::string& line : page.lines) {
    baseline += draw::kNoteLineMm;
    draw::draw_text(canvas, line, area.x_mm + kNoteInsetMm, baseline,
                    std::max(area.width_mm - 2 * kNoteInsetMm, 1.0),
                    {.size_mm = kNoteSizeMm, .ink = ink, .align = draw::TextAlign::Left});
  }
}

}  // namespace

BoardPage page_of_own_size(const Board& board, double margin_mm, std::vector<std::string> lines) {
  check_margin(margin_mm);
  BoardPage page;
  const double notes = notes_height(lines);
  page.board = {margin_mm, margin_mm, board.extent.width_mm, board.extent.height_mm};
  page.notes = {margin_mm, page.board.bottom_mm(), board.extent.width_mm, notes};
  page.width_mm = board.extent.width_mm + 2 * margin_mm;
  page.height_mm = page.notes.bottom_mm() + margin_mm;
  page.lines = std::move(lines);
  if (std::max(page.width_mm, page.height_mm) > draw::kMaxPageMm) {
    throw draw::DoesNotFit(
        fmt::format("a page of {} x {} is larger than the limit of {}", format_mm(page.width_mm),
                    format_mm(page.height_mm), format_mm(draw::kMaxPageMm)),
        "", "take a smaller edge or fewer tags");
  }
  return page;
}

BoardPage page_on_paper(const Board& board, double width_mm, double height_mm, double margin_mm,
                        std::vector<std::string> lines) {
  check_margin(margin_mm);
  for (const double side : {width_mm, height_mm}) {
    if (!(side > 0 && side <= draw::kMaxPageMm)) {
      throw std::invalid_argument(
          fmt::format("a paper side of {} mm cannot be; it is above 0 up to "
                      "{}",
                      side, draw::kMaxPageMm));
    }
  }
  const double notes = notes_height(lines);
  const double room_x = width_mm - 2 * margin_mm;
  const double room_y = height_mm - 2 * margin_mm - notes;
  const auto fits = [&](double x, double y) {
    return board.extent.width_mm <= x + kSlackMm && board.extent.height_mm <= y + kSlackMm;
  };
  if (!fits(room_x, room_y)) {
    const bool turned = fits(height_mm - 2 * margin_mm, width_mm - 2 * margin_mm - notes);
    throw draw::DoesNotFit(
        fmt::format(
            "the board of {} x {} does not fit on the paper: margin and notes leave {} x {}",
            format_mm(board.extent.width_mm), format_mm(board.extent.height_mm),
            format_mm(std::max(room_x, 0.0)), format_mm(std::max(room_y, 0.0))),
        fmt::format("{} x {}", format_mm(width_mm), format_mm(height_mm)),
        turned ? "turn the paper: it fits then"
               : "take a larger paper, a smaller margin or a smaller edge, or leave --paper out "
                 "for a page of the board's size");
  }
  BoardPage page;
  page.width_mm = width_mm;
  page.height_mm = height_mm;
  page.board = {(width_mm - board.extent.width_mm) / 2,
                margin_mm + (room_y - board.extent.height_mm) / 2, board.extent.width_mm,
                board.extent.height_mm};
  page.notes = {margin_mm, height_mm - margin_mm - notes, room_x, notes};
  page.lines = std::move(lines);
  return page;
}

void draw_board(draw::Canvas& canvas, const Board& board, const BoardPage& page) {
  const draw::Ink black{.gray = 0.0, .role = draw::Role::Tag};
  for (const BoardTag& tag : board.tags) {
    Path path;
    add_outlines(path, board, page, tag, draw::black_outlines(cells_of(tag)), false);
    canvas.fill(path, {}, black);
  }
  Path squares;
  for (const draw::Box& square : board.squares) {
    const PathPoint corner = on_page(board, page, {square.x_mm, square.y_mm});
    squares.add_rectangle(corner.x, corner.y, square.width_mm, square.height_mm);
  }
  if (!squares.empty()) canvas.fill(squares, {}, black);
  if (!page.lines.empty()) draw_notes(canvas, page);
}

Path white_ground(const Board& board, const BoardPage& page) {
  Path ground;
  ground.add_rectangle(0, 0, page.width_mm, page.height_mm);
  for (const BoardTag& tag : board.tags) {
    // Against the direction of the page: holes in it; tags inside them are white again.
    add_outlines(ground, board, page, tag, draw::hole_outlines(cells_of(tag)), true);
    if (!tag.host) continue;
    std::vector<PathPoint> corners;
    for (const detect::Point corner : square_around(tag, quiet_side_mm(tag))) {
      corners.push_back(on_page(board, page, corner));
    }
    std::reverse(corners.begin(), corners.end());
    ground.add_polygon(corners);
  }
  return ground;
}

}  // namespace tagmint::board
