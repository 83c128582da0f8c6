// The page of `tagmint info --html` in a real browser: it needs nothing from outside, its gallery
// finds tags and draws them as they are, and a detector reads the tags off its picture.
#include <gtest/gtest.h>

#include <memory>
#include <regex>
#include <set>
#include <string>

#include "cli/html/tag_svg.h"
#include "io/images.h"
#include "support/chromium.h"
#include "support/scratch_folder.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/rotation.h"
#include "tagmint/codec/tag_cells.h"
#include "tagmint/detect/detector.h"

namespace tagmint {
namespace {

std::string page_of(const test::ScratchFolder& folder, const std::string& family) {
  const std::string page = folder.file("page.html");
  const test::ProgramResult result = test::tagmint({"info", family, "--html", page});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return page;
}

/// Ids of the figures in the gallery, in their order.
std::vector<int> shown_ids(const std::string& dom) {
  static const std::regex figure("<figure id=\"tag-([0-9]+)\">");
  std::vector<int> ids;
  for (std::sregex_iterator at(dom.begin(), dom.end(), figure), end; at != end; ++at) {
    ids.push_back(std::stoi((*at)[1]));
  }
  return ids;
}

std::string status_of(const std::string& dom) {
  static const std::regex status("<p id=\"status\" role=\"status\">([^<]*)</p>");
  std::smatch match;
  return std::regex_search(dom, match, status) ? match[1].str() : std::string("no status");
}

TEST(FamilyPage, LoadsWithoutAComplaintAndFindsAnId) {
  const test::ScratchFolder folder;
  const std::string page = page_of(folder, "tag36h11");
  const test::LoadedPage loaded = test::load_page(page, "#ids=7");
  EXPECT_EQ(loaded.console, "");
  EXPECT_EQ(shown_ids(loaded.dom), std::vector<int>{7});
  EXPECT_EQ(status_of(loaded.dom), "1 tag found.");
  EXPECT_NE(loaded.dom.find("<code>0x1106cba43</code>"), std::string::npos);
}

// The page's policy lets it fetch nothing, and says so on the console if it tries: the test above
// sees that it does not. Here that such a line would be seen.
TEST(FamilyPage, RequestWouldBeSeen) {
  const test::ScratchFolder folder;
  std::string html = test::read_file(page_of(folder, "tag16h5"));
  ASSERT_NE(html.find("content=\"default-src 'none'"), std::string::npos);
  const std::string body = "<main>";
  html.insert(html.find(body) + body.size(), "<img alt=\"\" src=\"http://localhost:9/a.png\">");
  const test::LoadedPage loaded = test::load_page(folder.write("asking.html", html));
  EXPECT_NE(loaded.console.find("http://localhost:9/a.png"), std::string::npos) << loaded.console;
}

TEST(FamilyPage, FindsATurnedCodewordWithErrors) {
  const codec::SharedFamily family = codec::find_family("tagStandard41h12");
  const test::ScratchFolder folder;
  const codec::Codeword read =
      codec::rotate(family->codeword(2042), family->bits(), 1) ^ 0x10000000001;
  const test::LoadedPage loaded =
      test::load_page(page_of(folder, "tagStandard41h12"), "#code=" + codec::to_hex(read));
  EXPECT_EQ(loaded.console, "");
  EXPECT_EQ(shown_ids(loaded.dom), std::vector<int>{2042});
  EXPECT_NE(status_of(loaded.dom).find("The nearest one differs in 2 bits."), std::string::npos)
      << status_of(loaded.dom);
  EXPECT_NE(loaded.dom.find("hamming 2 rotation 3"), std::string::npos);
}

TEST(FamilyPage, DrawsTheTagsOfARangeAsTheyAre) {
  for (const char* name : {"rot48", "tagCircle21h7"}) {
    const codec::SharedFamily family = codec::find_family(name);
    const test::ScratchFolder folder;
    const test::LoadedPage loaded = test::load_page(page_of(folder, name), "#ids=3,20-37");
    const std::vector<int> ids = shown_ids(loaded.dom);
    ASSERT_EQ(ids.size(), 19U) << status_of(loaded.dom);
    EXPECT_EQ(ids[0], 3);
    EXPECT_EQ(ids[18], 37);
    for (const int id : ids) {
      const std::string path = cli::black_path(
          codec::tag_cells(family->layout(), family->codeword(static_cast<codec::TagId>(id))));
      EXPECT_NE(loaded.dom.find("d=\"" + path + "\""), std::string::npos) << name << " id " << id;
    }
    EXPECT_NE(loaded.dom.find("class=\"blank\" d=\"" + cli::blank_path(family->layout())),
              std::string::npos);
  }
}

TEST(FamilyPage, OfAFamilyOfMillionsSaysWhatItLists) {
  const test::ScratchFolder folder;
  const std::string page = page_of(folder, "rot48");
  EXPECT_LT(test::read_file(page).size(), 3'000'000U);
  const test::LoadedPage loaded = test::load_page(page, "#ids=150000");
  EXPECT_EQ(loaded.console, "");
  EXPECT_TRUE(shown_ids(loaded.dom).empty());
  EXPECT_EQ(status_of(loaded.dom),
            "There is no id 150000 here: ids are 0 to 149999. This page lists the first 150,000 of "
            "4,193,280 tags.");
}

TEST(FamilyPage, PictureOfItIsReadByTheDetector) {
  const test::ScratchFolder folder;
  const std::string png = folder.file("page.png");
  test::picture_page(page_of(folder, "tag36h11"), "#ids=100-111", 1000, 3000, true, png);
  const detect::Image picture = io::read_gray_image(png);
  EXPECT_EQ(picture.width(), 1000);
  EXPECT_EQ(picture.height(), 3000);
  detect::Detector detector(
      {std::make_shared<const codec::Decoder>(codec::find_family("tag36h11"))});
  std::set<int> ids;
  for (const detect::Detection& tag : detector.detect(picture)) {
    EXPECT_EQ(tag.hamming, 0);
    ids.insert(static_cast<int>(tag.id));
  }
  // Six stand beside the facts (0 also shows the sizes), twelve in the gallery.
  std::set<int> expected = {0, 1, 2, 3, 4, 5};
  for (int id = 100; id < 112; ++id) expected.insert(id);
  EXPECT_EQ(ids, expected);
}

}  // namespace
}  // namespace tagmint
