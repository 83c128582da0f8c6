#include "cli/board_input.h"

#include <gtest/gtest.h>

#include <string>

#include "cli/command.h"
#include "support/scratch_folder.h"

namespace tagmint::cli {
namespace {

using test::ScratchFolder;

template <typename Read>
std::string refusal(Read read) {
  try {
    read();
  } catch (const codec::Fault& fault) {
    return fault.what();
  }
  return "";
}

TEST(BoardInput, GridsAreColumnsByRows) {
  EXPECT_EQ(parse_grid("6x7").columns, 6);
  EXPECT_EQ(parse_grid("6x7").rows, 7);
  for (const char* text : {"0x3", "3x0", "-1x3", "3", "3x", "x3", "3x4x5", "3.5x2", "1001x1", ""}) {
    EXPECT_NE(refusal([&] {
                parse_grid(text);
              }).find("' is not a grid (--grid); write columns x rows, each from 1 to 1000"),
              std::string::npos)
        << text;
  }
}

TEST(BoardInput, SpacingIsAShareOfTheEdgeOrALength) {
  EXPECT_DOUBLE_EQ(parse_spacing_mm("0.3", 88), 26.4);
  EXPECT_DOUBLE_EQ(parse_spacing_mm("1.2cm", 88), 12);
  EXPECT_NE(refusal([] { parse_spacing_mm("-0.3", 88); }).find("is not above 0 (--spacing)"),
            std::string::npos);
  EXPECT_NE(refusal([] { parse_spacing_mm("0", 88); }), "");
  EXPECT_NE(refusal([] { parse_spacing_mm("-3mm", 88); }), "");
  EXPECT_NE(refusal([] { parse_spacing_mm("wide", 88); }), "");
  EXPECT_NE(refusal([] { parse_spacing_mm("3 yards", 88); }), "");
}

TEST(BoardInput, NestedTagsMayHaveAnEdge) {
  const draw::NestedRequest plain = parse_nested("tag36h11:7");
  EXPECT_EQ(plain.family->name(), "tag36h11");
  EXPECT_EQ(plain.id, 7u);
  EXPECT_EQ(plain.edge_mm, std::nullopt);
  EXPECT_DOUBLE_EQ(parse_nested("tag36h11:7:2cm").edge_mm.value(), 20);
  EXPECT_NE(refusal([] { parse_nested("tag36h11"); }).find("names no tag (--nested)"),
            std::string::npos);
  EXPECT_NE(refusal([] { parse_nested("tag36h11:587"); }).find("its ids are 0-586"),
            std::string::npos);
  EXPECT_NE(refusal([] { parse_nested("tag36h11:7:20"); }), "");
  EXPECT_NE(refusal([] { parse_nested("tag36h11:7:0mm"); }), "");
}

TEST(BoardInput, BundleTagsHaveAPlaceAndATurn) {
  const board::BoardTag tag = parse_bundle_tag("tag36h11:3:60mm@-4cm,12.5mm,-90deg");
  EXPECT_EQ(tag.id, 3u);
  EXPECT_DOUBLE_EQ(tag.edge_mm, 60);
  EXPECT_DOUBLE_EQ(tag.centre_mm.x, -40);
  EXPECT_DOUBLE_EQ(tag.centre_mm.y, 12.5);
  EXPECT_DOUBLE_EQ(tag.turn_deg, -90);
  EXPECT_DOUBLE_EQ(parse_bundle_tag("tag36h11:3:60mm@0mm,0mm").turn_deg, 0);
  for (const char* text :
       {"tag36h11:3:60mm", "tag36h11:3@0mm,0mm", "tag36h11:3:60mm@0mm",
        "tag36h11:3:60mm@0mm,0mm,90deg,1", "tag36h11:3:60mm@0,0", "tag36h11:3:60mm@0mm,0mm,90",
        "tag36h11:x:60mm@0mm,0mm", "tag36h11:3:60mm@--1mm,0mm", "tag36h11:3:60mm@0mm,0mm,361deg"}) {
    EXPECT_NE(refusal([&] { parse_bundle_tag(text); }).find("(--tag)"), std::string::npos) << text;
  }
}

TEST(BoardInput, BundleFilesHoldTheSame) {
  const ScratchFolder folder;
  const auto read = [&](const std::string& text) {
    return read_bundle(folder.write("bundle.json", text));
  };
  const auto tags = read(R"({"tags": [
    {"family": "tag36h11", "id": 3, "edge_mm": 60, "center_mm": [-40, 12.5], "turn_deg": -90},
    {"family": "tagStandard41h12", "id": 4, "outer_mm": 90, "center_mm": [50, 0]}]})");
  ASSERT_EQ(tags.size(), 2u);
  EXPECT_DOUBLE_EQ(tags[0].turn_deg, -90);
  EXPECT_DOUBLE_EQ(tags[0].centre_mm.x, -40);
  EXPECT_DOUBLE_EQ(tags[1].edge_mm, 50);
  const std::string where = " (" + folder.file("bundle.json") + ")";
  EXPECT_EQ(refusal([&] { read("{}"); }), "the bundle lacks 'tags'" + where + "; add it");
  EXPECT_EQ(refusal([&] { read(R"({"tags": []})"); }),
            "tags is empty" + where + "; give at least one tag");
  EXPECT_EQ(refusal([&] {
              read(R"({"tags": [{"family": "tag36h11", "id": 587, "edge_mm": 60,
                                 "center_mm": [0, 0]}]})");
            }),
            "tags[0].id is 587" + where + "; it must be a whole number from 0 to 586");
  EXPECT_EQ(
      refusal([&] { read(R"({"tags": [{"family": "tag36h11", "id": 1, "center_mm": [0, 0]}]})"); }),
      "tags[0] needs one of edge_mm and outer_mm" + where +
          "; give the side of the border square or of all");
  EXPECT_NE(refusal([&] {
              read(R"({"tags": [{"family": "tag36h11", "id": 1, "edge_mm": 60, "at": [0, 0]}]})");
            }),
            "");
  EXPECT_NE(refusal([&] { read("{"); }).find("not valid JSON"), std::string::npos);
}

}  // namespace
}  // namespace tagmint::cli
