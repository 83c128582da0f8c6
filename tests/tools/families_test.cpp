#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "support/scratch_folder.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::test {
namespace {

using Json = nlohmann::json;

TEST(Families, JsonHasExactlyThePromisedKeys) {
  const ProgramResult result = tagmint({"families", "--format", "json"});
  ASSERT_EQ(result.exit_code, 0);
  const Json json = Json::parse(result.out);
  ASSERT_EQ(json.size(), 1U);
  const Json& families = json.at("families");
  ASSERT_EQ(families.size(), codec::family_names().size());
  for (std::size_t i = 0; i < families.size(); ++i) {
    EXPECT_EQ(families[i].at("name"), codec::family_names()[i]);
    EXPECT_EQ(families[i].size(), 9U);
    const Json& last = families[i].at("levels").back();
    EXPECT_EQ(last.at("codes"), families[i].at("codes"));
    EXPECT_EQ(last.at("min_hamming"), families[i].at("min_hamming"));
    EXPECT_EQ(last.size(), last.contains("plain") ? 3U : 2U);
  }
}

TEST(Families, JsonOfTag36h11) {
  const Json json = Json::parse(tagmint({"families", "--format", "json"}).out);
  const Json expected = {{"name", "tag36h11"},
                         {"bits", 36},
                         {"codes", 587},
                         {"min_hamming", 11},
                         {"safe_radius", 5},
                         {"layout", "classic:10"},
                         {"width_at_border", 8},
                         {"total_width", 10},
                         {"levels", Json::array({{{"codes", 587}, {"min_hamming", 11}}})}};
  bool found = false;
  for (const Json& family : json.at("families")) found = found || family == expected;
  EXPECT_TRUE(found);
}

TEST(Families, TextHasOneLineAFamilyUnderItsHeader) {
  const std::string text = tagmint({"families"}).out;
  EXPECT_TRUE(text.starts_with("name ")) << text;
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')),
            codec::family_names().size() + 1);
  EXPECT_NE(text.find("tag36h11             36      587        11     5        8/10  classic:10"),
            std::string::npos)
      << text;
}

TEST(Families, FormatFollowsTheExtensionOfTheFile) {
  const ScratchFolder folder;
  const std::string file = folder.file("families.json");
  EXPECT_EQ(tagmint({"families", "-o", file}).out, "");
  EXPECT_EQ(read_file(file), tagmint({"families", "--format", "json"}).out);
  EXPECT_EQ(tagmint({"families", "-o", file, "--format", "text"}).exit_code, 0);
  EXPECT_EQ(read_file(file), tagmint({"families"}).out);
  EXPECT_EQ(tagmint({"families", "-o", "-"}).out, tagmint({"families"}).out);
}

}  // namespace
}  // namespace tagmint::test
