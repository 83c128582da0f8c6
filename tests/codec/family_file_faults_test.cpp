// Malformed family files: each fault gives one line with the place and a remedy.

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>

#include "support/generated_families.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::codec {
namespace {

/// A small family file: three codewords of 16 bits, two levels. Line numbers are in the comments of
/// the tests that break it.
std::string sound_file() {
  return format_family(Family({.name = "small",
                               .layout = classic_layout(8),
                               .min_hamming = 5,
                               .codewords = {0x231b, 0x2ea5, 0x346a},
                               .complexity = {ComplexityRule::Rectangles, 5},
                               .origin = {"lexicode", "apriltag2", "160505", "complete", "test"},
                               .levels = {{2, 6}, {3, 5}}}));
}

/// The sound file with `from` replaced by `to`; `from` must be there.
std::string with(const std::string& from, const std::string& to) {
  std::string text = sound_file();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string fault_of(const std::string& text) {
  try {
    parse_family(text, "f.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// The line of the file that holds `text`, counted from 1.
int line_of(const std::string& file, const std::string& text) {
  const auto at = file.begin() + static_cast<std::ptrdiff_t>(file.find(text));
  return 1 + static_cast<int>(std::count(file.begin(), at, '\n'));
}

/// The fault must have `what`, the line of `place` in the broken file, and a remedy, all in one
/// line.
void expect_fault(const std::string& file, const std::string& what, const std::string& place) {
  const std::string fault = fault_of(file);
  const std::string where = "(f.json:" + std::to_string(line_of(file, place)) + "); ";
  EXPECT_NE(fault.find(what), std::string::npos) << fault;
  EXPECT_NE(fault.find(where), std::string::npos) << fault << "\nexpected " << where;
  EXPECT_EQ(fault.find('\n'), std::string::npos) << fault;
}

TEST(FamilyFileFaults, TheUnbrokenFileIsAccepted) { EXPECT_EQ(fault_of(sound_file()), "accepted"); }

TEST(FamilyFileFaults, ATruncatedFileIsAlwaysRefused) {
  const std::string file = sound_file();
  for (std::size_t length = 0; length + 1 < file.size(); ++length) {
    const std::string fault = fault_of(file.substr(0, length));
    EXPECT_NE(fault.find("this is not JSON"), std::string::npos) << length << ": " << fault;
    EXPECT_TRUE(std::regex_search(fault, std::regex(R"(\(f\.json:\d+\); )"))) << fault;
  }
}

TEST(FamilyFileFaults, AnyByteMayBeBrokenWithoutACrash) {
  const std::string file = sound_file();
  for (std::size_t i = 0; i < file.size(); ++i) {
    for (const char byte : {'\0', '"', '}', ']', '{', '\n', '9', '\xff'}) {
      std::string broken = file;
      broken[i] = byte;
      const std::string fault = fault_of(broken);  // InputError or accepted, nothing else
      EXPECT_EQ(fault.find('\n'), std::string::npos) << fault;
    }
  }
}

TEST(FamilyFileFaults, NotJson) {
  expect_fault("\n\n  hello", "this is not JSON", "hello");
  expect_fault(with("\"version\":1,", "\"version\":1 \"bits\":2,"), "this is not JSON",
               "\"version\"");
  expect_fault(sound_file() + "{}", "this is not JSON", "{}");
  expect_fault(with("\"version\":1", "\"version\":1e999"), "this is not JSON", "1e999");
  EXPECT_LT(fault_of("[\"" + std::string(100000, 'x')).size(), 500u);
}

TEST(FamilyFileFaults, NotAnObject) {
  expect_fault("[]", "one JSON object, this is a list", "[]");
  expect_fault("\n5", "one JSON object, this is a number", "5");
  expect_fault("null", "one JSON object, this is null", "null");
}

TEST(FamilyFileFaults, DeeplyNestedUnknownValuesAreNoDanger) {
  const std::string deep = std::string(200000, '[') + std::string(200000, ']');
  EXPECT_EQ(fault_of("{\"x\":" + deep + "," + sound_file().substr(1)), "accepted");
}

TEST(FamilyFileFaults, AnotherFormatOrVersion) {
  expect_fault(with("tagmint-family", "tagmint-board"), "not a tagmint family file",
               "tagmint-board");
  expect_fault("{\"nmarkers\":50,\n\"markersize\":4}", "not a tagmint family file", "nmarkers");
  expect_fault(with("\"version\":1", "\"version\":2"), "version 2 is unknown", "\"version\"");
}

TEST(FamilyFileFaults, MissingKeys) {
  for (const char* key : {"version", "name", "bits", "min_hamming", "layout", "sha256", "codes"}) {
    const std::string quoted = std::string("\"") + key + "\"";
    const std::string fault = fault_of(with("  " + quoted, "  \"other\""));
    EXPECT_NE(fault.find("the key " + quoted + " is missing"), std::string::npos) << fault;
  }
}

TEST(FamilyFileFaults, ValuesOfTheWrongKind) {
  expect_fault(with("\"bits\":16", "\"bits\":\"16\""), "\"bits\" holds a string", "\"bits\"");
  // The number is followed by the line break: still its line.
  expect_fault(with("\"bits\":16,", "\"bits\":-16\n,"), "\"bits\" holds -16", "\"bits\"");
  expect_fault(with("\"bits\":16,", "\"bits\":1.5\n,"), "\"bits\" holds 1.5", "\"bits\"");
  expect_fault(with("\"name\":\"small\"", "\"name\":null"), "\"name\" holds null", "\"name\"");
  expect_fault(with("\"name\":\"small\"", "\"name\":[\"small\"]"), "\"name\" holds a list",
               "\"name\"");
  expect_fault(with("{\"rule\":\"rectangles\",\"threshold\":5}", "\"rectangles:5\""),
               "\"complexity\" holds a string", "\"complexity\"");
  expect_fault(with("\"0x000000000000231b\"", "8987"), "\"codes[]\" holds a number", "8987");
  expect_fault(with("\"codes\":[", "\"codes\":{"), "\"codes\" holds an object", "\"codes\":{");
  expect_fault(with("\"seed\":\"160505\"", "\"seed\":true"), "holds true or false", "\"seed\"");
}

TEST(FamilyFileFaults, AKeyThatComesTwice) {
  expect_fault(with("\"min_hamming\":5,\n", "\"bits\" : 16,\n"), "the key \"bits\" comes twice",
               "\"bits\" :");
}

TEST(FamilyFileFaults, Names) {
  expect_fault(with("small", ""), "family name '' is not possible", "\"name\"");
  expect_fault(with("small", "a\\nb/c"), "family name 'a\\x0ab/c' is not possible", "\"name\"");
}

TEST(FamilyFileFaults, Layouts) {
  expect_fault(with("wbbbbbbw", "wbbbbbw"), "layout row 1 has 7 cells", "\"layout\"");
  expect_fault(with("wbbbbbbw", "wbbqbbbw"), "layout has 'q' in row 1, column 3", "\"layout\"");
  expect_fault(with("wbddddbw", "wbdwddbw"), "changes under a quarter turn", "\"layout\"");
  expect_fault(
      "{\"format\":\"tagmint-family\",\"version\":1,\"name\":\"x\",\"bits\":1,\n\"layout\":[]}",
      "layout", "\"layout\"");
  expect_fault(with("\"bits\":16", "\"bits\":17"),
               "\"bits\" is 17, but the layout has 16 data cells", "\"bits\"");
}

TEST(FamilyFileFaults, Distances) {
  expect_fault(with("\"min_hamming\":5,\n", "\"min_hamming\":0,\n"), "distance 0 is not possible",
               "\"min_hamming\"");
  expect_fault(with("\"min_hamming\":5,\n", "\"min_hamming\":17,\n"), "distance 17 is not possible",
               "\"min_hamming\"");
  expect_fault(with("\"min_hamming\":5,\n", "\"min_hamming\":99999999999,\n"), "is not possible",
               "\"min_hamming\"");
}

TEST(FamilyFileFaults, Codewords) {
  expect_fault(with("0x0000000000002ea5", "0x2ea5"), "codeword 1 is \"0x2ea5\"", "\"0x2ea5\"");
  expect_fault(with("0x0000000000002ea5", "0x000000000000zea5"), "codeword 1 is", "zea5");
  expect_fault(with("0x0000000000002ea5", "0x-000000000002ea5"), "codeword 1 is", "0x-0");
  expect_fault(with("0x0000000000002ea5", "0x0000000000012ea5"),
               "codeword 1 (0x0000000000012ea5) has more than the layout's 16 bits", "12ea5");
  expect_fault(with("0x000000000000346a", "0x000000000000231B"),
               "codewords 0 and 2 are the same (0x000000000000231b)", "231B");
  expect_fault(
      "{\"format\":\"tagmint-family\",\"version\":1,\"name\":\"x\",\"bits\":1,\"min_hamming\":1,"
      "\"layout\":[\"wwwww\",\"wbbbw\",\"wbdbw\",\"wbbbw\",\"wwwww\"],\n\"codes\":[]}",
      "\"codes\" is empty", "\"codes\"");
}

TEST(FamilyFileFaults, Levels) {
  expect_fault(with("{\"codes\":2,\"min_hamming\":6}", "{\"codes\":3,\"min_hamming\":6}"),
               "level 1 must have more codes", "\"levels\"");
  expect_fault(with("{\"codes\":3,\"min_hamming\":5}", "{\"codes\":4,\"min_hamming\":5}"),
               "the last level must be the whole family: 3 codes at distance 5", "\"levels\"");
  expect_fault(with("{\"codes\":2,\"min_hamming\":6}", "{\"codes\":2}"), "level 0 lacks",
               "\"levels\"");
  expect_fault(with("{\"codes\":2,\"min_hamming\":6}", "7"), "\"levels[]\" holds a number",
               "    7,");
}

TEST(FamilyFileFaults, Complexity) {
  expect_fault(with("\"rule\":\"rectangles\"", "\"rule\":\"rectangle\""),
               "did you mean 'rectangles'", "\"rule\"");
  expect_fault(with("\"threshold\":5", "\"threshold\":2.5"), "needs a whole number",
               "\"threshold\"");
  expect_fault(with(",\"threshold\":5", ""), "needs a whole number", "\"rule\"");
  expect_fault(with("\"rule\":\"rectangles\",", ""), "has no \"rule\"", "\"threshold\"");
}

TEST(FamilyFileFaults, Digest) {
  const std::string fault = fault_of(with("0x000000000000346a", "0x000000000000346b"));
  EXPECT_NE(fault.find("the codewords are not those that \"sha256\" was made of (f.json:"),
            std::string::npos);
  // What the message proposes is accepted.
  std::string file = with("0x000000000000346a", "0x000000000000346b");
  const std::size_t at = file.find("\"sha256\":\"") + 10;
  file.replace(at, 64, fault.substr(fault.size() - 64));
  EXPECT_EQ(fault_of(file), "accepted");
}

/// The file of a generated family of 16 bits with `from` replaced by `to`.
std::string generated_with(const std::string& from, const std::string& to) {
  std::string text = format_family(Family(test::generated_16()));
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(FamilyFileFaults, Generators) {
  EXPECT_EQ(fault_of(generated_with("\"sha256\"", "\"sha256\"")), "accepted");
  expect_fault(generated_with("\"generator\":{", "\"codes\":[],\"generator\":{"),
               "both \"codes\" and \"generator\" are given", "\"generator\"");
  expect_fault(generated_with("\"basis\"", "\"base\""), "the generator has no \"basis\"",
               "\"generator\"");
  expect_fault(generated_with("0x0000000000005555", "0x5555"),
               "\"generator.basis[]\" is \"0x5555\"", "\"0x5555\"");
  expect_fault(generated_with("\"0x0000000000000007\"", "7"),
               "\"generator.translation\" holds a number", "\"translation\"");
  expect_fault(generated_with("0x0000000000005555", "0x0000000000005557"),
               "level 0 is not closed under turns: the turn of basis word 0 (0x0000000000005557)",
               "\"generator\"");
  expect_fault(generated_with("0x0000000000005555", "0x0000000000015555"),
               "basis word 0 (0x0000000000015555) has more than 16 bits", "\"generator\"");
  expect_fault(generated_with("0x0000000000005555", "0x0000000000000000"),
               "is a sum of those before it", "\"generator\"");
  expect_fault(generated_with("0x000000000000157e", "0x0000000000001cdd"),
               "cosets 14 and 15 are the same", "\"generator\"");
  expect_fault(generated_with("\"dimension\":2,\"cosets\":4", "\"dimension\":2,\"cosets\":3"),
               "level 0 is not closed under turns: the turn of coset 2", "\"generator\"");
  expect_fault(generated_with("\"dimension\":2,", ""), "lacks \"dimension\"", "\"generator\"");
  expect_fault(generated_with("\"cosets\":16", "\"cosets\":99999999999999999999"),
               "\"generator.levels[].cosets\" holds", "99999");
}

TEST(FamilyFileFaults, LevelsOfGenerators) {
  expect_fault(generated_with("\"codes\":4,", "\"codes\":5,"),
               "level 0 has 5 codes, the generator makes 4", "\"generator\"");
  expect_fault(generated_with("\"codes\":16,", "\"codes\":17,"),
               "the last level must be the whole family: 16 codes at distance 5", "\"levels\"");
  expect_fault(generated_with("{\"codes\":4,\"min_hamming\":6},", ""),
               "the family has 1 levels, its generator 2", "\"generator\"");
  expect_fault(generated_with("\"codes\":4,", "\"codes\":4,\"plain\":5,"),
               "level 0 has 5 plain tags, but adds only 4 tags", "\"levels\"");
  expect_fault(generated_with("\"codes\":4,", "\"codes\":4,\"plain\":-1,"),
               "\"levels[].plain\" holds -1", "\"plain\"");
  // Another family of as many bits.
  std::string wide = generated_with("\"bits\":16", "\"bits\":25");
  wide.replace(wide.find("    \"wwwwwwww\","), wide.find("  ],") - wide.find("    \"wwwwwwww\","),
               "\"wwwwwwwww\",\"wbbbbbbbw\",\"wbdddddbw\",\"wbdddddbw\",\"wbdddddbw\","
               "\"wbdddddbw\",\"wbdddddbw\",\"wbbbbbbbw\",\"wwwwwwwww\"");
  expect_fault(wide, "level 0 is not closed under turns", "\"generator\"");
}

TEST(FamilyFileFaults, AnyByteOfAGeneratorMayBeBrokenWithoutACrash) {
  const std::string file = format_family(Family(test::generated_16()));
  for (std::size_t i = 0; i < file.size(); ++i) {
    for (const char byte : {'"', '}', '[', '\n', '9', 'f'}) {
      std::string broken = file;
      broken[i] = byte;
      EXPECT_EQ(fault_of(broken).find('\n'), std::string::npos);
    }
  }
  for (std::size_t length = 0; length + 1 < file.size(); length += 7) {
    EXPECT_NE(fault_of(file.substr(0, length)).find("this is not JSON"), std::string::npos);
  }
}

}  // namespace
}  // namespace tagmint::codec
