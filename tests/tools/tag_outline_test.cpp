#include "draw/tag_outline.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tagmint/codec/layout_presets.h"

namespace tagmint::draw {
namespace {

using codec::Cell;
using codec::CellPosition;
using codec::TagCells;

TagCells cells_of(const std::vector<std::string>& rows) {
  std::vector<Cell> cells;
  for (const std::string& row : rows) {
    for (const char c : row) cells.push_back(static_cast<Cell>(c));
  }
  return TagCells(static_cast<int>(rows.size()), cells);
}

/// How often the outlines wind around the centre of a cell, clockwise.
int winding(const std::vector<Outline>& outlines, int x, int y) {
  int turns = 0;
  for (const Outline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const CellPosition a = outline[i];
      const CellPosition b = outline[(i + 1) % outline.size()];
      // A ray to the left of the cell's centre crosses vertical edges at columns 0..x.
      if (a.x != b.x || a.x > x) continue;
      if (a.y <= y && y < b.y) --turns;
      if (b.y <= y && y < a.y) ++turns;
    }
  }
  return turns;
}

/// Twice nothing: every point is a turn, every edge runs along the grid and has a length.
void expect_clean(const std::vector<Outline>& outlines) {
  for (const Outline& outline : outlines) {
    ASSERT_GE(outline.size(), 4u);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const CellPosition a = outline[i];
      const CellPosition b = outline[(i + 1) % outline.size()];
      const CellPosition c = outline[(i + 2) % outline.size()];
      EXPECT_NE(a.x == b.x, a.y == b.y);
      EXPECT_NE(a.x == b.x, b.x == c.x);
    }
  }
}

TEST(TagOutline, OneCellIsASquareClockwise) {
  const auto outlines = black_outlines(cells_of({"www", "wbw", "www"}));
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_EQ(outlines[0], (Outline{{1, 1}, {2, 1}, {2, 2}, {1, 2}}));
}

TEST(TagOutline, ARingHasAHoleTheOtherWayRound) {
  const auto outlines = black_outlines(cells_of({"bbb", "bwb", "bbb"}));
  ASSERT_EQ(outlines.size(), 2u);
  EXPECT_EQ(outlines[0], (Outline{{0, 0}, {3, 0}, {3, 3}, {0, 3}}));
  EXPECT_EQ(outlines[1].size(), 4u);
  EXPECT_EQ(winding(outlines, 1, 1), 0);
}

TEST(TagOutline, CellsThatTouchAtACornerStayApart) {
  EXPECT_EQ(black_outlines(cells_of({"bw", "wb"})).size(), 2u);
  EXPECT_EQ(black_outlines(cells_of({"wb", "bw"})).size(), 2u);
}

TEST(TagOutline, NeighboursShareNoEdge) {
  const auto outlines = black_outlines(cells_of({"bbb", "bbb", "bbw"}));
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_EQ(outlines[0], (Outline{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 3}, {0, 3}}));
}

TEST(TagOutline, EveryPatternOfFourTimesFourCellsIsCoveredOnce) {
  for (int pattern = 0; pattern < 1 << 16; ++pattern) {
    std::vector<Cell> cells;
    for (int i = 0; i < 16; ++i) cells.push_back((pattern >> i) & 1 ? Cell::Black : Cell::White);
    const auto outlines = black_outlines(TagCells(4, cells));
    for (int i = 0; i < 16; ++i) {
      ASSERT_EQ(winding(outlines, i % 4, i / 4), (pattern >> i) & 1) << pattern << " cell " << i;
    }
  }
}

TEST(TagOutline, TagsOfEveryLayoutAreCoveredOnce) {
  for (const char* name : {"classic:10", "standard:9", "circle:11"}) {
    const codec::Layout layout = codec::parse_layout(name);
    for (std::uint64_t i = 1; i < 50; ++i) {
      const codec::Codeword word = i * 0x9e3779b97f4a7c15u & codec::low_mask(layout.bits());
      const TagCells cells = codec::tag_cells(layout, word);
      const auto outlines = black_outlines(cells);
      expect_clean(outlines);
      for (int y = 0; y < cells.width(); ++y) {
        for (int x = 0; x < cells.width(); ++x) {
          ASSERT_EQ(winding(outlines, x, y), cells.at(x, y) == Cell::Black ? 1 : 0);
        }
      }
    }
  }
}

TEST(TagOutline, OnlyEnclosedAbsentCellsAreHoles) {
  EXPECT_TRUE(hole_outlines(cells_of({"xbx", "bwb", "xbx"})).empty());
  const auto outlines = hole_outlines(cells_of({"xbbb", "bxxb", "bxwb", "bbbb"}));
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_EQ(outlines[0], (Outline{{1, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}}));
  // A way out, even round a corner, makes it no hole; a corner alone is no way.
  EXPECT_TRUE(hole_outlines(cells_of({"bxbb", "bxxb", "bbxb", "bbbb"})).empty());
}

}  // namespace
}  // namespace tagmint::draw
