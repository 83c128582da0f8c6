#include "cli/tag_request.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/paper.h"

namespace tagmint::cli {
namespace {

std::string parts(std::string_view text) {
  const TagRequest request = split_tag_request(text);
  return request.family + "|" + request.edge + "|" + request.ids;
}

std::string complaint(const std::string& text, const TagDefaults& defaults) {
  try {
    resolve_tag_request(text, defaults);
  } catch (const UsageError& fault) {
    return fault.what();
  }
  return "accepted";
}

std::string paper_complaint(std::string_view text) {
  try {
    parse_paper(text);
  } catch (const UsageError& fault) {
    return fault.what();
  }
  return "accepted";
}

TEST(TagRequest, IsSplitFromItsEnd) {
  EXPECT_EQ(parts("tag36h11"), "tag36h11||");
  EXPECT_EQ(parts("tag36h11:40mm"), "tag36h11|40mm|");
  EXPECT_EQ(parts("tag36h11:40mm:0-9,12,20-"), "tag36h11|40mm|0-9,12,20-");
  EXPECT_EQ(parts("tag36h11::3"), "tag36h11||3");
  EXPECT_EQ(parts("c:/families/my.json:40mm:7"), "c:/families/my.json|40mm|7");
  // A size without a unit stays a size, so that the message can say what is missing.
  EXPECT_EQ(parts("tag36h11:40"), "tag36h11|40|");
}

TEST(TagRequest, SaysItsOwnSizeAndIdsOrTakesTheDefaults) {
  const TagDefaults defaults{.edge_mm = 30.0, .outer_mm = {}, .ids = "5"};
  EXPECT_EQ(resolve_tag_request("tag16h5", defaults).edge_mm, 30);
  EXPECT_EQ(resolve_tag_request("tag16h5", defaults).ids, (std::vector<codec::TagId>{5}));
  EXPECT_EQ(resolve_tag_request("tag16h5:2cm:3,1", defaults).edge_mm, 20);
  EXPECT_EQ(resolve_tag_request("tag16h5:2cm:3,1", defaults).ids,
            (std::vector<codec::TagId>{1, 3}));
  // 8 cells in all, 6 within the border square.
  const TagDefaults outer{.edge_mm = {}, .outer_mm = 80.0, .ids = ""};
  EXPECT_DOUBLE_EQ(resolve_tag_request("tag16h5", outer).edge_mm, 60);
  EXPECT_EQ(resolve_tag_request("tag16h5", outer).ids.size(), 30u);
}

TEST(TagRequest, FaultsAreNamed) {
  EXPECT_NE(complaint("tag16h5", {}).find("the size of the tags is missing (tag16h5); give --edge"),
            std::string::npos);
  for (const char* request : {"tag16h5:0mm", "tag16h5:1e-300mm", "tag16h5:0.09mm"}) {
    EXPECT_NE(complaint(request, {}).find("below 0.1 mm"), std::string::npos) << request;
  }
  EXPECT_EQ(complaint("tag16h5:0-3", {}),
            "'0-3' stands where the size belongs (tag16h5:0-3); write tag16h5::0-3 or "
            "tag16h5:40mm:0-3");
  EXPECT_NE(complaint("tag16h5:40", {}).find("no unit"), std::string::npos);
  EXPECT_NE(complaint("tag16h5:40mm:30", {}).find("30"), std::string::npos);
}

TEST(Paper, NamesAndSidesAreRead) {
  EXPECT_EQ(parse_paper("A4").height_mm, 297);
  EXPECT_EQ(parse_paper("a0").width_mm, 841);
  EXPECT_EQ(parse_paper("a6").width_mm, 105);
  EXPECT_NEAR(parse_paper("letter").width_mm, 215.9, 1e-9);
  EXPECT_NEAR(parse_paper("legal").height_mm, 355.6, 1e-9);
  EXPECT_EQ(parse_paper("100x150mm").width_mm, 100);
  EXPECT_EQ(parse_paper("100x150mm").height_mm, 150);
  EXPECT_NEAR(parse_paper("4x6in").width_mm, 101.6, 1e-9);
  EXPECT_EQ(parse_paper("10cmx150mm").width_mm, 100);
}

TEST(Paper, FaultsAreNamed) {
  EXPECT_NE(paper_complaint("leter").find("unknown paper 'leter' (--paper); did you mean 'letter'"),
            std::string::npos);
  EXPECT_NE(paper_complaint("100x150").find("no unit"), std::string::npos);
  EXPECT_NE(paper_complaint("0x150mm").find("cannot be"), std::string::npos);
  EXPECT_NE(paper_complaint("100x9000mm").find("at most 5080 mm"), std::string::npos);
}

}  // namespace
}  // namespace tagmint::cli
