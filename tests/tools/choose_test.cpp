// `tagmint choose` as its users meet it.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/scratch_folder.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

/// The command line for `tags` tags of 40 mm, a camera of 600 px and 1 m, with changes.
Words choose(const std::string& tags, const Words& more = {}, const std::string& distance = "1m") {
  Words words = {"choose",   "--tags",          tags,         "--edge", "40mm",
                 "--camera", "600,600,320,240", "--distance", distance};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Words of a command that the program printed, without the leading "tagmint".
Words words_of(const std::string& command) {
  std::istringstream stream(command);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  EXPECT_EQ(words.at(0), "tagmint");
  words.erase(words.begin());
  return words;
}

TEST(ChooseProgram, JsonRanksEveryBundledFamily) {
  const ProgramResult result = tagmint(choose("100", {"--format", "json"}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const Json json = Json::parse(result.out);
  std::set<std::string> names;
  for (const Json& family : json.at("families")) names.insert(family.at("family"));
  EXPECT_TRUE(names.contains("tag36h11"));
  for (const Json& family : json.at("too_few_tags")) {
    EXPECT_LT(family.at("codes").get<int>(), 100);
    names.insert(family.at("family"));
  }
  EXPECT_EQ(names.size(), codec::family_names().size());
  EXPECT_EQ(json.at("recommended"), json.at("families")[0].at("family"));
  EXPECT_DOUBLE_EQ(json.at("distance_m"), 1.0);
  const auto tag36h11 =
      std::find_if(json.at("families").begin(), json.at("families").end(),
                   [](const Json& family) { return family.at("family") == "tag36h11"; });
  EXPECT_DOUBLE_EQ(tag36h11->at("pixels_per_cell"), 3.0);
  EXPECT_EQ(tag36h11->at("ids"), "0-99");
  EXPECT_EQ(tag36h11->at("read_by"), (Json{"libapriltag", "OpenCV"}));
  EXPECT_EQ(tag36h11->at("warnings"), Json::array());
}

TEST(ChooseProgram, TheCommandsThatItPrintsWork) {
  const ScratchFolder folder;
  const Json best =
      Json::parse(tagmint(choose("4", {"--format", "json"})).out).at("families").at(0);
  Words print = words_of(best.at("print"));
  const std::string sheet = folder.file("tags.png");
  ASSERT_EQ(print.back(), "tags.pdf");
  print.back() = sheet;
  ASSERT_EQ(tagmint(print).exit_code, 0);
  Words find = words_of(best.at("find"));
  ASSERT_EQ(find.back(), "IMAGE...");
  find.back() = sheet;
  find.insert(find.end(), {"--format", "jsonl", "--decimate", "4"});
  const ProgramResult found = tagmint(find);
  ASSERT_EQ(found.exit_code, 0) << found.err;
  EXPECT_EQ(Json::parse(found.out).at("detections").size(), 4U);
}

TEST(ChooseProgram, TextRecommendsInItsFirstLines) {
  const ProgramResult result = tagmint(choose("30"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::vector<std::string> lines = lines_of(result.out);
  const Json json = Json::parse(tagmint(choose("30", {"--format", "json"})).out);
  const Json& best = json.at("families").at(0);
  EXPECT_TRUE(lines.at(0).starts_with(best.at("family").get<std::string>() + ", ids 0-29 ("))
      << lines[0];
  EXPECT_EQ(lines.at(1), "  print  " + best.at("print").get<std::string>());
  EXPECT_EQ(lines.at(2), "  find   " + best.at("find").get<std::string>());
  // A row a family.
  for (const std::string& name : codec::family_names()) {
    EXPECT_NE(result.out.find(name + " "), std::string::npos) << name;
  }
}

TEST(ChooseProgram, RanksFamilyFilesTooByTheirPath) {
  const ScratchFolder folder;
  const std::string path = folder.file("mine.json");
  codec::FamilyParts parts{.name = "mine",
                           .layout = codec::find_family("tag36h11")->layout(),
                           .min_hamming = 10,
                           .codewords = {0x1, 0x2, 0x4},
                           .complexity = {},
                           .origin = {},
                           .levels = {{2, 16}, {3, 10}}};
  codec::write_family(codec::Family(parts), path);
  const Json json = Json::parse(tagmint(choose("2", {"--format", "json", "--family", path})).out);
  const auto mine = std::find_if(json.at("families").begin(), json.at("families").end(),
                                 [](const Json& family) { return family.at("family") == "mine"; });
  ASSERT_NE(mine, json.at("families").end());
  EXPECT_EQ(mine->at("min_hamming"), 16);
  EXPECT_EQ(mine->at("larger_levels"), Json::parse(R"([{"codes":3,"min_hamming":10}])"));
  EXPECT_NE(mine->at("print").get<std::string>().find("sheet " + path + " "), std::string::npos);
  EXPECT_EQ(tagmint(choose("2", {"--family", folder.file("none.json")})).exit_code, 3);
}

TEST(ChooseProgram, AnswersOneWhenNothingCanBeReadOrHasEnoughTags) {
  const ProgramResult far = tagmint(choose("30", {}, "90m"));
  EXPECT_EQ(far.exit_code, 1);
  EXPECT_NE(far.out.find("are too small: 0 % of the tags are read"), std::string::npos) << far.out;
  const ProgramResult many = tagmint(choose("4e9"));
  EXPECT_EQ(many.exit_code, 1);
  EXPECT_TRUE(many.out.starts_with("no family has 4000000000 tags\n")) << many.out;
  const Json json = Json::parse(tagmint(choose("4e9", {"--format", "json"})).out);
  EXPECT_TRUE(json.at("recommended").is_null());
}

TEST(ChooseProgram, TakesTheWholeSideInstead) {
  const Json json = Json::parse(tagmint({"choose", "--tags", "9", "--outer", "5cm", "--camera",
                                         "900,800,640,360", "--distance", "2m", "--format", "json"})
                                    .out);
  EXPECT_DOUBLE_EQ(json.at("focal_px"), 800.0);  // the shorter one
  for (const Json& family : json.at("families")) EXPECT_NEAR(family.at("outer_mm"), 50, 1e-9);
}

TEST(ChooseProgram, TellsFaultsInOneLine) {
  const Words rest = {"--camera", "600,600,320,240", "--distance", "1m"};
  const auto with = [&](Words words) {
    words.insert(words.begin(), "choose");
    words.insert(words.end(), rest.begin(), rest.end());
    return words;
  };
  expect_fault(with({"--tags", "9"}), 2,
               "the size of the tags is missing (--edge); give --edge (side of the border square) "
               "or --outer (side of the whole tag)");
  expect_fault(with({"--tags", "9", "--edge", "4cm", "--outer", "5cm"}), 2,
               "the size of the tags is given twice (--edge); give --edge (side of the border "
               "square) or --outer (side of the whole tag)");
  expect_fault(with({"--tags", "9", "--edge", "40"}), 2,
               "the length '40' has no unit (--edge); add one of mm, cm, m, in, pt, like 40mm");
  expect_fault(with({"--tags", "9", "--edge", "0mm"}), 2,
               "the length must be above 0 (--edge); write it with its unit, like 40mm");
  expect_fault({"choose", "--tags", "9", "--edge", "4cm", "--camera", "600", "--distance", "1m"}, 2,
               "'600' has 1 numbers, 4 are needed (--camera); give FX,FY,CX,CY in pixels");
  EXPECT_EQ(tagmint(with({"--tags", "0", "--edge", "4cm"})).exit_code, 2);
  EXPECT_EQ(tagmint({"choose", "--tags", "9"}).exit_code, 2);
}

}  // namespace
}  // namespace tagmint::test
