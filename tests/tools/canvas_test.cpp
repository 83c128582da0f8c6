// What each kind of file says of a small drawing.
#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "draw/file_canvas.h"
#include "draw/numbers.h"
#include "draw/text.h"
#include "draw/utf8.h"
#include "io/images.h"
#include "tagmint/codec/errors.h"

namespace tagmint::draw {
namespace {

/// A page of 20 mm x 10 mm with a square of 4 mm at (2, 3), a line and a text.
std::string drawing(FileKind kind, FileOptions options = {}, int pages = 1) {
  std::string content;
  const auto canvas = make_canvas(kind, options, [&](std::string_view b) { content += b; });
  for (int page = 0; page < pages; ++page) {
    canvas->begin_page({.width_mm = 20,
                        .height_mm = 10,
                        .label = page == 1 ? "map" : "",
                        .bookmarks = {{"Tägs " + std::to_string(page), 0}, {"ids 0-3", 1}}});
    if (has_white_ground(kind, options)) {
      Path paper;
      paper.add_rectangle(0, 0, 20, 10);
      canvas->paint_ground(paper);
    }
    Path square;
    square.add_rectangle(0, 0, 2, 2);
    canvas->fill(square, {2, 3, 2.0}, {.gray = 0, .role = Role::Tag});
    Path line;
    line.add_line(1, 9, 19, 9);
    canvas->stroke(line, {}, {.width_mm = 0.2, .ink = {.gray = 0.5, .role = Role::Cut}});
    draw_text(*canvas, "é1(", 10, 5, 8, {.size_mm = 2, .ink = {.role = Role::Label}});
    canvas->end_page();
  }
  canvas->finish();
  return content;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Canvas, NumbersHaveNoExponentAndNoNeedlessDigits) {
  EXPECT_EQ(number_text(1.5, 5), "1.5");
  EXPECT_EQ(number_text(100, 5), "100");
  EXPECT_EQ(number_text(100, 0), "100");
  EXPECT_EQ(number_text(-0.000001, 5), "0");
  EXPECT_EQ(number_text(1e-3, 5), "0.001");
  EXPECT_EQ(number_text(2.834645669291339, 9), "2.834645669");
}

TEST(Canvas, Utf8IsReadAndWritten) {
  const std::string text = "aé€😀";
  const std::u32string characters = characters_of(text);
  ASSERT_EQ(characters, U"aé€😀");
  std::string again;
  for (const char32_t c : characters) again += utf8_of(c);
  EXPECT_EQ(again, text);
  for (const char* bad : {"\xff", "\xc0\x80", "\xed\xa0\x80", "\xe2\x82", "\xf5\x80\x80\x80"}) {
    EXPECT_THROW(characters_of(bad), std::invalid_argument);
  }
}

TEST(Canvas, KindsHaveNames) {
  for (const std::string_view name : file_kind_names()) {
    const auto kind = file_kind_of(name);
    ASSERT_TRUE(kind) << name;
    EXPECT_EQ(name_of(*kind), name);
  }
  EXPECT_EQ(file_kind_of("tif"), FileKind::Tiff);
  EXPECT_FALSE(file_kind_of("bmp"));
}

TEST(PdfCanvas, AsksForActualSizeAndTellsPagesAndContents) {
  FileOptions options;
  options.title = "Lab";
  const std::string pdf = drawing(FileKind::Pdf, options, 3);
  EXPECT_TRUE(pdf.starts_with("%PDF-1.7\n"));
  EXPECT_TRUE(has(pdf, "/ViewerPreferences<</PrintScaling/None/DisplayDocTitle true>>"));
  EXPECT_TRUE(has(pdf, "/Title <FEFF004C00610062>"));
  EXPECT_TRUE(has(pdf, "/Count 3/Kids["));
  // Numbers, but for the second page; the third goes on with its own number.
  EXPECT_TRUE(
      has(pdf, "/PageLabels<</Nums[0<</S/D/St 1>>1<</P <FEFF006D00610070>>>2<</S/D/St 3>>]>>"));
  EXPECT_TRUE(has(pdf, "/PageMode/UseOutlines"));
  EXPECT_TRUE(has(pdf, "<FEFF005400E4006700730020"));  // "Täg"
  // 20 mm = 56.6929 pt.
  EXPECT_TRUE(has(pdf, "/MediaBox[0 0 56.692913 28.346457]"));
  EXPECT_FALSE(has(pdf, "CreationDate"));
}

TEST(PdfCanvas, EveryObjectStandsWhereTheTableSays) {
  const std::string pdf = drawing(FileKind::Pdf, {}, 2);
  const std::size_t at = std::stoul(pdf.substr(pdf.rfind("startxref\n") + 10));
  std::istringstream table(pdf.substr(at));
  std::string word;
  std::size_t first = 0, count = 0;
  table >> word >> first >> count;
  ASSERT_EQ(word, "xref");
  ASSERT_EQ(first, 0u);
  for (std::size_t number = 0; number < count; ++number) {
    std::string place, generation, kind;
    table >> place >> generation >> kind;
    ASSERT_EQ(kind, number == 0 ? "f" : "n");
    if (number == 0) continue;
    const std::string head = std::to_string(number) + " 0 obj\n";
    EXPECT_EQ(pdf.substr(std::stoul(place), head.size()), head);
  }
}

TEST(SvgCanvas, SaysItsSizeAndGroupsWhatBelongsTogether) {
  FileOptions options;
  options.title = "a <b> & \"c\"";
  const std::string svg = drawing(FileKind::Svg, options);
  EXPECT_TRUE(has(svg, "width=\"20mm\" height=\"10mm\" viewBox=\"0 0 20 10\""));
  EXPECT_TRUE(has(svg, "@page{size:20mm 10mm;margin:0}"));
  EXPECT_TRUE(has(svg, "<title>a &lt;b&gt; &amp; &quot;c&quot;</title>"));
  EXPECT_TRUE(has(svg, "<g id=\"tags\">\n<path fill=\"#000000\" d=\"M2 3H6V7H2Z\"/>"));
  EXPECT_TRUE(has(svg,
                  "<g id=\"cut\">\n<path fill=\"none\" stroke=\"#808080\" stroke-width=\"0.2\" "
                  "d=\"M1 9H19\"/>"));
  EXPECT_TRUE(has(svg, "<g id=\"labels\">"));
  EXPECT_TRUE(has(svg, "id=\"ground\" fill=\"#ffffff\""));
  options.white_ground = false;
  EXPECT_FALSE(has(drawing(FileKind::Svg, options), "ground"));
}

TEST(PsCanvas, FollowsTheDocumentConventions) {
  FileOptions options;
  options.title = "Täg (1)";
  const std::string ps = drawing(FileKind::Ps, options, 2);
  EXPECT_TRUE(ps.starts_with("%!PS-Adobe-3.0\n"));
  EXPECT_TRUE(has(ps, "%%Title: (T?g \\(1\\))\n"));
  EXPECT_TRUE(has(ps, "%%Page: (1) 1\n"));
  EXPECT_TRUE(has(ps, "%%Page: (map) 2\n"));
  EXPECT_TRUE(has(ps, "<</PageSize[56.69291 28.34646]>>setpagedevice"));
  EXPECT_TRUE(ps.ends_with("%%Trailer\n%%Pages: 2\n%%EOF\n"));
  const std::string eps = drawing(FileKind::Eps, options);
  EXPECT_TRUE(eps.starts_with("%!PS-Adobe-3.0 EPSF-3.0\n"));
  EXPECT_TRUE(has(eps, "%%BoundingBox: 0 0 57 29\n%%HiResBoundingBox: 0 0 56.69291 28.34646\n"));
  EXPECT_FALSE(has(eps, "setpagedevice"));
}

TEST(PsCanvas, BlackIsAGrayLevelOrTheKeyPlate) {
  FileOptions options;
  EXPECT_TRUE(has(drawing(FileKind::Ps, options), "/I{setgray}"));
  options.ink_model = InkModel::Key;
  EXPECT_TRUE(has(drawing(FileKind::Ps, options), "setcmykcolor"));
  EXPECT_FALSE(has(drawing(FileKind::Ps, options), "setgray"));
}

/// The groups of a DXF file: code and value.
std::vector<std::pair<int, std::string>> dxf_groups(const std::string& dxf) {
  std::vector<std::pair<int, std::string>> groups;
  std::istringstream lines(dxf);
  std::string code, value;
  while (std::getline(lines, code) && std::getline(lines, value)) {
    groups.emplace_back(std::stoi(code), value);
  }
  return groups;
}

TEST(DxfCanvas, HasClosedLinesInMillimetresOnLayers) {
  const auto groups = dxf_groups(drawing(FileKind::Dxf));
  EXPECT_EQ(groups.back(), (std::pair<int, std::string>{0, "EOF"}));
  // The first polyline is the square: its corners with y up from the page's lower edge.
  std::vector<PathPoint> corners;
  std::string layer;
  bool closed = false, inside = false;
  for (std::size_t i = 0; i < groups.size() && !(inside && groups[i].second == "SEQEND"); ++i) {
    if (groups[i] == std::pair<int, std::string>{0, "POLYLINE"}) inside = true;
    if (!inside) continue;
    if (groups[i].first == 70) closed = groups[i].second == "1";
    if (groups[i] != std::pair<int, std::string>{0, "VERTEX"}) continue;
    layer = groups[i + 1].second;
    corners.push_back({std::stod(groups[i + 2].second), std::stod(groups[i + 3].second)});
  }
  EXPECT_TRUE(closed);
  EXPECT_EQ(layer, "TAGS");
  EXPECT_EQ(corners, (std::vector<PathPoint>{{2, 7}, {6, 7}, {6, 3}, {2, 3}}));
  EXPECT_TRUE(has(drawing(FileKind::Dxf), "$INSUNITS\n70\n4\n"));
}

TEST(OutlineCanvas, FillsNothing) {
  FileOptions options;
  options.outline = true;
  const std::string svg = drawing(FileKind::Svg, options);
  EXPECT_FALSE(has(svg, "fill=\"#"));
  EXPECT_FALSE(has(svg, "<use"));
  // 0.001 inch.
  EXPECT_TRUE(
      has(svg, "fill=\"none\" stroke=\"#000000\" stroke-width=\"0.0254\" d=\"M2 3H6V7H2Z\""));
  EXPECT_FALSE(has(drawing(FileKind::Eps, options), "F\n%%"));
}

TEST(RasterCanvas, PixelsAreWhereTheDrawingIs) {
  FileOptions options;
  options.dpi = 254;  // ten pixels a mm
  for (const FileKind kind : {FileKind::Png, FileKind::Tiff}) {
    for (const int bits : {1, 8}) {
      options.bits = bits;
      const detect::Image image = io::decode_gray_image(drawing(kind, options), "drawing");
      ASSERT_EQ(image.width(), 200);
      ASSERT_EQ(image.height(), 100);
      for (int y = 25; y < 75; ++y) {
        for (int x = 15; x < 65; ++x) {
          const bool inside = x >= 20 && x < 60 && y >= 30 && y < 70;
          ASSERT_EQ(image.at(x, y), inside ? 0 : 255) << x << ", " << y << ", " << bits;
        }
      }
      // A line in half ink: gray, or black where there is one bit.
      EXPECT_NEAR(image.at(100, 90), bits == 1 ? 0 : 127, 1);
    }
  }
}

TEST(RasterCanvas, OneBitFilesAreOfOneBitAndTransparentOnesHaveNoGround) {
  FileOptions options;
  options.bits = 1;
  const std::string one_bit = drawing(FileKind::Png, options);
  EXPECT_EQ(one_bit[24], 1);  // IHDR: bits a sample
  EXPECT_EQ(one_bit[25], 0);  // gray
  EXPECT_FALSE(has(one_bit, "tRNS"));
  options.white_ground = false;
  EXPECT_TRUE(has(drawing(FileKind::Png, options), "tRNS"));
  options.bits = 8;
  EXPECT_EQ(drawing(FileKind::Png, options)[25], 4);  // gray and alpha
  // Seen over white, it is the same picture.
  const auto pixels = [&](bool white) {
    options.white_ground = white;
    const detect::Image image = io::decode_gray_image(drawing(FileKind::Tiff, options), "drawing");
    return std::vector<std::uint8_t>(image.row(0), image.row(0) + image.width() * image.height());
  };
  EXPECT_EQ(pixels(true), pixels(false));
}

TEST(RasterCanvas, HoldsOnePageOfLimitedSize) {
  EXPECT_THROW(drawing(FileKind::Png, {}, 2), std::logic_error);
  FileOptions options;
  options.dpi = 100000;
  EXPECT_THROW(drawing(FileKind::Png, options), codec::OutputError);
}

}  // namespace
}  // namespace tagmint::draw
