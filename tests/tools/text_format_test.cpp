#include "draw/text_format.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace tagmint::draw {
namespace {

constexpr std::array<std::string_view, 3> kFields = {"family", "id", "edge"};

std::string expanded(std::string_view text) {
  const std::vector<FieldValue> values = {{"family", "tag16h5"}, {"id", std::uint64_t{7}}};
  return TextFormat(text, kFields).expand(values);
}

std::string complaint(std::string_view text) {
  try {
    expanded(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(TextFormat, FieldsAreReplacedByTheirValues) {
  EXPECT_EQ(expanded("{family}-{id}.svg"), "tag16h5-7.svg");
  EXPECT_EQ(expanded("plain"), "plain");
  EXPECT_EQ(expanded(""), "");
}

TEST(TextFormat, NumbersArePaddedToTheirWidth) {
  EXPECT_EQ(expanded("{id:05}"), "00007");
  EXPECT_EQ(expanded("{id:3}"), "  7");
  EXPECT_EQ(expanded("{id:1}"), "7");
}

TEST(TextFormat, DoubledBracesAreBraces) { EXPECT_EQ(expanded("{{{id}}}"), "{7}"); }

TEST(TextFormat, TellsWhichFieldsItUses) {
  const TextFormat format("{id}", kFields);
  EXPECT_TRUE(format.uses("id"));
  EXPECT_FALSE(format.uses("family"));
  EXPECT_TRUE(format.has_fields());
  EXPECT_FALSE(TextFormat("{{id}}", kFields).has_fields());
}

TEST(TextFormat, FaultsAreNamed) {
  EXPECT_EQ(complaint("{famly}"),
            "unknown field {famly}; did you mean 'family'? the fields are {family}, {id}, {edge}");
  EXPECT_NE(complaint("{").find("'{' without '}'"), std::string::npos);
  EXPECT_NE(complaint("a}").find("'}' without '{'"), std::string::npos);
  EXPECT_NE(complaint("{id:x}").find("'x' is no width of the field {id}"), std::string::npos);
  EXPECT_NE(complaint("{id:}").find("is no width"), std::string::npos);
  EXPECT_NE(complaint("{id:00}").find("is no width"), std::string::npos);
  EXPECT_NE(complaint("{id:9999}").find("is no width"), std::string::npos);
  EXPECT_NE(complaint("{family:5}").find("is no number"), std::string::npos);
  EXPECT_NE(complaint("{edge}").find("has no value"), std::string::npos);
}

}  // namespace
}  // namespace tagmint::draw
