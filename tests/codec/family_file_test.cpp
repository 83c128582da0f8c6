#include "tagmint/codec/family_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "tagmint/codec/errors.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::codec {
namespace {

namespace fs = std::filesystem;

void expect_same(const Family& a, const Family& b) {
  EXPECT_EQ(a.name(), b.name());
  EXPECT_EQ(a.layout(), b.layout());
  EXPECT_EQ(a.min_hamming(), b.min_hamming());
  EXPECT_TRUE(std::equal(a.codewords().begin(), a.codewords().end(), b.codewords().begin(),
                         b.codewords().end()));
  EXPECT_EQ(a.complexity(), b.complexity());
  EXPECT_EQ(a.origin(), b.origin());
  EXPECT_TRUE(
      std::equal(a.levels().begin(), a.levels().end(), b.levels().begin(), b.levels().end()));
}

Family nested_family() {
  return Family({.name = "nested",
                 .layout = classic_layout(8),
                 .min_hamming = 3,
                 .codewords = {0x231b, 0x2ea5, 0x346a, 0xffff},
                 .complexity = {ComplexityRule::Energy, 0.3333},
                 .origin = {"by \"hand\"", "seed:1", "-42", "a\nb\\", "\xff not UTF-8"},
                 .levels = {{2, 6}, {3, 4}, {4, 3}}});
}

TEST(FamilyFile, WritesOneCodewordALine) {
  const Family family({.name = "two",
                       .layout = classic_layout(5),
                       .min_hamming = 1,
                       .codewords = {0, 1},
                       .complexity = {},
                       .origin = {},
                       .levels = {}});
  EXPECT_EQ(format_family(family), R"({
  "format":"tagmint-family",
  "version":1,
  "name":"two",
  "bits":1,
  "min_hamming":1,
  "layout":[
    "wwwww",
    "wbbbw",
    "wbdbw",
    "wbbbw",
    "wwwww"
  ],
  "complexity":{"rule":"none"},
  "origin":{"method":"","order":"","seed":"","searched":"","program":""},
  "sha256":"49fc3ab15797697f3cc603db69c2d14b412c94a7a4bca7f0cb0a45422c52fb86",
  "codes":[
    "0x0000000000000000",
    "0x0000000000000001"
  ]
}
)");
}

TEST(FamilyFile, ComesBackAsItWasWritten) {
  Family family = nested_family();
  const Family back = parse_family(format_family(family), "memory");
  EXPECT_EQ(back.origin().searched, "a\nb\\");
  EXPECT_EQ(back.origin().program, "\xef\xbf\xbd not UTF-8") << "bytes that JSON cannot hold";
  EXPECT_EQ(back.levels().size(), 3u);
  expect_same(parse_family(format_family(back), "memory"), back);
}

TEST(FamilyFile, IsWrittenToAndReadFromTheDisk) {
  const fs::path path = fs::temp_directory_path() / "tagmint-family-file-test.json";
  const Family family = parse_family(format_family(nested_family()), "memory");
  write_family(family, path);
  expect_same(read_family(path), family);
  fs::remove(path);
}

TEST(FamilyFile, UnknownKeysAreIgnoredWhateverTheyHold) {
  const std::string known = format_family(nested_family());
  const std::string more = R"({"comment":["layout",{"bits":7,"codes":[1,null,[{}]]}],"":0,
    "complexity.rule":5,"generator_of":{"basis":[1.5,true]},"x":null,)" +
                           known.substr(1);
  const Family family = parse_family(more, "memory");
  EXPECT_EQ(family.size(), 4u);
  EXPECT_EQ(family.complexity().rule, ComplexityRule::Energy);
}

TEST(FamilyFile, ComplexityOriginAndLevelsMayBeMissing) {
  const Family family = parse_family(R"({"format":"tagmint-family","version":1,"name":"t","bits":1,
    "min_hamming":1,"layout":["wwwww","wbbbw","wbdbw","wbbbw","wwwww"],"codes":["0x0000000000000001"],
    "sha256":"889e70453893b1d60b08b68a1c0a5d1c95a4acd126d5a59b146151cb3c69f929"})",
                                     "memory");
  EXPECT_EQ(family.complexity(), Complexity{});
  EXPECT_EQ(family.origin(), Origin{});
  ASSERT_EQ(family.levels().size(), 1u);
}

TEST(FamilyFile, CannotBeReadFromNowhereOrAFolder) {
  EXPECT_THROW(read_family("/no/such/family.json"), InputError);
  EXPECT_THROW(read_family(fs::temp_directory_path()), InputError);
  EXPECT_THROW(read_family("/dev/null"), InputError);
}

}  // namespace
}  // namespace tagmint::codec
