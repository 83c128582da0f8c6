#include "tagmint/codec/layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::codec {
namespace {

constexpr const char* kCustom48 =
    "dddddddddd/dbbbbbbbbd/dbwwwwwwbd/dbwddddwbd/dbwdxxdwbd/"
    "dbwdxxdwbd/dbwddddwbd/dbwwwwwwbd/dbbbbbbbbd/dddddddddd";

std::string message_of(const std::string& name) {
  try {
    parse_layout(name);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

struct Published {
  const char* layout;
  int bits;
  int total_width;
  int width_at_border;
  bool reversed;
};

TEST(Layout, PublishedLayoutsHaveTheirBitsAndBorders) {
  for (const Published& p :
       {Published{"classic:8", 16, 8, 6, false}, Published{"classic:9", 25, 9, 7, false},
        Published{"classic:10", 36, 10, 8, false}, Published{"circle:9", 21, 9, 5, true},
        Published{"standard:9", 41, 9, 5, true}, Published{"circle:11", 49, 11, 5, true},
        Published{"standard:10", 52, 10, 6, true}, Published{"classic:12", 64, 12, 10, false}}) {
    const Layout layout = parse_layout(p.layout);
    EXPECT_EQ(layout.bits(), p.bits) << p.layout;
    EXPECT_EQ(layout.width(), p.total_width) << p.layout;
    EXPECT_EQ(layout.width_at_border(), p.width_at_border) << p.layout;
    EXPECT_EQ(layout.reversed_border(), p.reversed) << p.layout;
    EXPECT_EQ(layout_name(layout), p.layout);
  }
}

TEST(Layout, CustomLayoutKeepsItsHole) {
  const Layout layout = parse_layout(std::string("custom:") + kCustom48);
  EXPECT_EQ(layout.bits(), 48);
  EXPECT_EQ(layout.width_at_border(), 6);
  EXPECT_TRUE(layout.reversed_border());
  EXPECT_EQ(layout.cell(4, 4), Cell::None);
  EXPECT_EQ(layout_name(layout), std::string("custom:") + kCustom48);
  EXPECT_EQ(parse_layout(layout_name(layout)), layout);
}

TEST(Layout, RowsMayComeWithoutSlashes) {
  EXPECT_EQ(Layout("wwwwwwbbbwwbdbwwbbbwwwwww"), Layout("wwwww/wbbbw/wbdbw/wbbbw/wwwww"));
}

TEST(Layout, CircleLooksLikeThePublishedOne) {
  const std::vector<std::string> rows = {"xxxdddxxx", "xbbbbbbbx", "xbwwwwwbx",
                                         "dbwdddwbd", "dbwdddwbd", "dbwdddwbd",
                                         "xbwwwwwbx", "xbbbbbbbx", "xxxdddxxx"};
  EXPECT_EQ(circle_layout(9).rows(), rows);
}

TEST(Layout, DataCellsAreFourTurnsOfOneBlockThenTheCentre) {
  for (const char* name : {"classic:8", "classic:9", "standard:9", "circle:11"}) {
    const Layout layout = parse_layout(name);
    const auto cells = layout.data_cells();
    const std::size_t block = cells.size() / 4;
    std::set<std::pair<int, int>> seen;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      seen.insert({cells[i].x, cells[i].y});
      if (i + block < 4 * block) {
        const CellPosition turned{layout.width() - 1 - cells[i].y, cells[i].x};
        EXPECT_EQ(cells[i + block], turned) << name << " cell " << i;
      }
    }
    EXPECT_EQ(seen.size(), cells.size()) << name;
    EXPECT_EQ(cells[0].y, std::min_element(cells.begin(), cells.end(), [](auto a, auto b) {
                            return a.y < b.y;
                          })->y);
  }
}

TEST(Layout, PicturesAndWordsAreInverse) {
  const Layout layout = circle_layout(11);
  const Codeword word = 0x123456789abcdu & low_mask(layout.bits());
  const TagCells cells = tag_cells(layout, word);
  EXPECT_EQ(codeword_of(layout, cells), word);
  EXPECT_EQ(cells.at(0, 0), Cell::None);
  EXPECT_EQ(cells.at(2, 2), Cell::Black);
  EXPECT_EQ(cells.at(3, 3), Cell::White);
}

TEST(Layout, FirstCellIsTheMostSignificantBit) {
  const TagCells cells = tag_cells(classic_layout(8), Codeword{1} << 15);
  EXPECT_EQ(cells.at(2, 2), Cell::White);
  EXPECT_EQ(cells.at(3, 2), Cell::Black);
}

TEST(Layout, TheExampleOfItsDocumentationIsOne) {
  EXPECT_EQ(Layout("wwwww/wbbbw/wbdbw/wbbbw/wwwww").bits(), 1);
}

TEST(Layout, FaultsAreNamed) {
  EXPECT_EQ(message_of("clasic:8"),
            "unknown layout 'clasic:8'; did you mean 'classic'? layouts are classic:W, standard:W, "
            "circle:W, custom:ROWS");
  EXPECT_EQ(message_of("classic"),
            "unfinished layout 'classic'; layouts are classic:W, standard:W, circle:W, "
            "custom:ROWS");
  EXPECT_EQ(message_of(""),
            "unknown layout ''; layouts are classic:W, standard:W, circle:W, custom:ROWS");
  EXPECT_NE(message_of("classic:8x").find("whole number"), std::string::npos);
  EXPECT_NE(message_of("classic:4").find("5 to 64 cells"), std::string::npos);
  EXPECT_NE(message_of("classic:100").find("5 to 64 cells"), std::string::npos);
  EXPECT_NE(message_of("classic:40").find("1296 data cells"), std::string::npos);
  EXPECT_NE(message_of("custom:wwww/wbbw/wbbw").find("row 0 has 4 cells, but there are 3 rows"),
            std::string::npos);
  EXPECT_NE(message_of("custom:wwwww").find("not a square"), std::string::npos);
  EXPECT_NE(message_of("custom:wwwww/wbbbw/wbqbw/wbbbw/wwwww").find("'q' in row 2, column 2"),
            std::string::npos);
  EXPECT_NE(message_of("custom:dwwww/wbbbw/wbdbw/wbbbw/wwwww").find("changes under a quarter turn"),
            std::string::npos);
  EXPECT_NE(message_of("custom:ddddd/ddddd/ddddd/ddddd/ddddd").find("no border"),
            std::string::npos);
  EXPECT_NE(message_of("custom:wwww/wbbw/wbbw/wwww").find("0 data cells"), std::string::npos);
  EXPECT_NE(message_of("custom:").find("layout"), std::string::npos);
}

}  // namespace
}  // namespace tagmint::codec
