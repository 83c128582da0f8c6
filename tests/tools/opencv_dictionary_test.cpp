// OpenCV dictionaries as users have them: YAML, JSON, packed, in a map of their own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "io/family_kinds/gzip.h"
#include "io/family_kinds/opencv.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/rotation.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::io {
namespace {

ReadFamily read(const std::string& content, const FamilyReadOptions& options = {}) {
  return read_opencv({.path = "d.yml", .name = "d.yml", .content = content}, options);
}

std::string fault_of(const std::string& content) {
  try {
    read(content);
    return "no fault";
  } catch (const codec::InputError& fault) {
    return fault.what();
  }
}

/// Two markers of 3 x 3 cells, row by row: 0x1a7, 0x034.
const codec::Family& expected() {
  static const codec::Family family =
      read("nmarkers: 2\nmarkersize: 3\nmarker_0: \"110100111\"\nmarker_1: \"000110100\"\n").family;
  return family;
}

TEST(OpenCvDictionary, BitsAreRowByRowAndWhiteIsOne) {
  EXPECT_EQ(expected().layout().width(), 7);
  const codec::TagCells cells = codec::tag_cells(expected().layout(), expected().codeword(0));
  EXPECT_EQ(cells.rows()[2], "wbwwbbw");
  EXPECT_EQ(cells.rows()[3], "wbwbbbw");
  EXPECT_EQ(cells.rows()[4], "wbwwwbw");
  EXPECT_EQ(expected().name(), "d");
}

TEST(OpenCvDictionary, FormsMayVary) {
  for (const std::string& text : {
           std::string("%YAML:1.0\n---\nnmarkers: 2\nmarkersize: 3\nmaxCorrectionBits: 0\n"
                       "marker_0: \"110100111\"\nmarker_1: \"000110100\"\n...\n"),
           std::string("nmarkers: 2\r\nmarkersize: 3 # cells\r\nmarker_1: '000110100'\r\n"
                       "marker_0: 110100111 # not quoted\r\nauthor: me\r\n"),
           std::string("%YAML 1.2\n---\n\"nmarkers\": 2\n\"markersize\": 3\n"
                       "\"marker_0\": \"110100111\"\n\"marker_1\": \"000110100\"\n"),
           std::string("{\"nmarkers\":2,\"markersize\":3,\"maxCorrectionBits\":-1,"
                       "\"marker_0\":\"110100111\",\"marker_1\":\"000110100\"}"),
           std::string("\n{\n  \"mine\": {\n    \"nmarkers\": 2,\n    \"markersize\": 3,\n    "
                       "\"marker_0\": \"110100111\",\n    \"marker_1\": \"000110100\"\n  }\n}\n"),
           std::string("%YAML:1.0\n---\nmine:\n   nmarkers: 2\n   markersize: 3\n"
                       "   marker_0: \"110100111\"\n   marker_1: \"000110100\"\n"),
       }) {
    SCOPED_TRACE(text);
    const codec::Family family = read(text).family;
    EXPECT_EQ(family.layout(), expected().layout());
    EXPECT_TRUE(std::ranges::equal(family.codewords(), expected().codewords()));
    EXPECT_EQ(family.name(), text.find("mine") == std::string::npos ? "d" : "mine");
  }
}

TEST(OpenCvDictionary, MissingKeyIsTold) {
  EXPECT_EQ(fault_of("markersize: 3\nmarker_0: \"110100111\"\n"),
            "the key 'nmarkers' is missing (d.yml); get the file anew");
}

TEST(OpenCvDictionary, ZerosThatYamlLostAreTold) {
  EXPECT_EQ(fault_of("nmarkers: 1\nmarkersize: 3\nmarker_0: 11010011\n"),
            "'marker_0' is not 9 characters 0 and 1 (d.yml:3); correct it; between quotes, lest "
            "zeros in front be lost");
}

TEST(OpenCvDictionary, TurnIsThatOfTheOptionOfTheFileOrNone) {
  const std::string text =
      "nmarkers: 2\nmarkersize: 3\nmarker_0: \"110100111\"\nmarker_1: \"000110100\"\n";
  const codec::Codeword upright = expected().codeword(0);
  const codec::Codeword turned = codec::rotate(upright, 9, 2);
  EXPECT_NE(upright, turned);
  EXPECT_EQ(read(text).family.codeword(0), upright);
  EXPECT_EQ(read(text, {.opencv = OpenCvTurn::HalfTurned}).family.codeword(0), turned);
  EXPECT_EQ(read(text, {.opencv = OpenCvTurn::Upright}).family.codeword(0), upright);
  EXPECT_EQ(read(text + "tagmint_opencv: 4\n").family.codeword(0), turned);
  EXPECT_EQ(read(text + "tagmint_opencv: 5\n").family.codeword(0), upright);
  EXPECT_EQ(fault_of(text + "tagmint_opencv: 3\n"),
            "'tagmint_opencv' is 3 (d.yml:5); it is a whole number from 4 to 5");
}

TEST(OpenCvDictionary, CorrectedBitsAreWrittenAsHalfTheDistance) {
  for (const auto& [family, bits] :
       {std::pair{"tag16h5", 2}, std::pair{"tag25h9", 4}, std::pair{"tag36h10", 4}}) {
    const auto files = make_opencv(*codec::find_family(family), "a.yml", {});
    ASSERT_EQ(files.size(), 1U);
    EXPECT_NE(files[0].content.find(fmt::format("\nmaxCorrectionBits: {}\n", bits)),
              std::string::npos);
  }
}

TEST(OpenCvDictionary, JsonFaultsAreToldWithTheirLine) {
  const std::string mend =
      "; an OpenCV dictionary is one map of keys with numbers and quoted texts";
  EXPECT_EQ(fault_of("{\n  \"nmarkers\": 2,\n  \"markersize\": \n}\n"),
            "a number or a text is missing (d.yml:4)" + mend);
  EXPECT_EQ(fault_of("{\n  \"nmarkers\": 2\n  \"markersize\": 3\n}\n"),
            "'markersize' stands where '}' is due (d.yml:3)" + mend);
  EXPECT_EQ(fault_of("{\n  \"nmarkers\": 2,\n"),
            "a key between quotes is missing (d.yml:2)" + mend);
  EXPECT_EQ(fault_of("{\"nmarkers\": [2]}"), "a number or a text is missing (d.yml:1)" + mend);
  EXPECT_EQ(fault_of("{\"a\": {\"nmarkers\": 2}, \"b\": {\"nmarkers\": 2}}"),
            "a map 'b' beside other keys (d.yml:1)" + mend);
  EXPECT_EQ(fault_of("{}\n{}"), "something follows the last brace (d.yml:2)" + mend);
}

TEST(Gzip, ComesBackWhole) {
  std::string text;
  for (std::size_t i = 0; i < 300'000; ++i) text += fmt::format("{} ", i * i % 1009);
  for (const std::string& content : {std::string(), std::string("x"), text}) {
    EXPECT_TRUE(is_gzip(gzip(content)));
    EXPECT_EQ(gunzip(gzip(content), "x"), content);
    EXPECT_EQ(gunzip(gzip(content) + gzip("tail"), "x"), content + "tail");
  }
  EXPECT_FALSE(is_gzip(""));
}

TEST(Gzip, DamageIsTold) {
  const std::string packed = gzip("some text that is worth packing");
  const auto fault = [](const std::string& bytes) -> std::string {
    try {
      gunzip(bytes, "a.gz");
      return "no fault";
    } catch (const codec::InputError& error) {
      return error.what();
    }
  };
  for (std::size_t length = 2; length < packed.size(); ++length) {
    EXPECT_EQ(fault(packed.substr(0, length)),
              "the gzip file is cut short (a.gz); get the file anew");
  }
  std::string damaged = packed;
  damaged[packed.size() - 6] ^= 1;  // of the checksum
  EXPECT_EQ(fault(damaged), "the gzip file is damaged (a.gz); get the file anew");
}

}  // namespace
}  // namespace tagmint::io
