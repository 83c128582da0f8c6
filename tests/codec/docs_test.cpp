// What docs/ shows is what the library does.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/places.h"
#include "tagmint/codec/family_check.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::codec {
namespace {

/// The text between "```<language>" and "```" in a file of docs/.
std::string code_block(const std::string& file, const std::string& language) {
  std::ifstream stream(test::source_folder() / "docs" / file);
  std::ostringstream content;
  content << stream.rdbuf();
  const std::string text = content.str();
  const std::string opening = "```" + language + "\n";
  const std::size_t begin = text.find(opening);
  if (begin == std::string::npos) return {};
  const std::size_t from = begin + opening.size();
  return text.substr(from, text.find("```", from) - from);
}

TEST(Docs, TheFamilyFileOfTheFormatPageIsSoundAndJustAsItWouldBeWritten) {
  const std::string json = code_block("family-format.md", "json");
  const Family family = parse_family(json, "docs/family-format.md");
  EXPECT_EQ(format_family(family), json);
  const FamilyCheck check = check_family(family);
  EXPECT_FALSE(check.violation) << check.violation->message;
}

TEST(Docs, TheGeneratedFamilyOfTheFormatPageIsSoundAndJustAsItWouldBeWritten) {
  const std::string json = code_block("family-format.md", "json generated");
  const Family family = parse_family(json, "docs/family-format.md");
  EXPECT_FALSE(family.is_listed());
  EXPECT_EQ(family_digest(family), family.declared_digest());
  EXPECT_EQ(format_family(family), json);
}

TEST(Docs, TheDrawnWalksAreThoseOfTheLayouts) {
  for (const char* name : {"classic:8", "circle:9"}) {
    const Layout layout = parse_layout(name);
    std::vector<std::string> expected;
    for (const std::string& row : layout.rows()) {
      for (const char cell : row) expected.emplace_back(1, cell);
    }
    int number = 0;
    for (const CellPosition p : layout.data_cells()) {
      expected[static_cast<std::size_t>(p.y * layout.width() + p.x)] = std::to_string(number++);
    }
    std::istringstream drawn(code_block("layouts.md", name));
    std::vector<std::string> cells;
    for (std::string cell; drawn >> cell;) cells.push_back(cell);
    EXPECT_EQ(cells, expected) << name;
  }
}

}  // namespace
}  // namespace tagmint::codec
