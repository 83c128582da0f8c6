#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/cell_picture.h"
#include "support/generated_families.h"
#include "support/scratch_folder.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/rotation.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::test {
namespace {

using Json = nlohmann::json;

TEST(CellPicture, WhiteIsBlocksBlackIsBlankAndNothingIsDots) {
  using codec::Cell;
  const codec::TagCells cells(2, {Cell::White, Cell::Black, Cell::None, Cell::White});
  EXPECT_EQ(cli::cell_picture(cells), "██  \n··██\n");
}

TEST(Encode, ShowsCodewordAndPicture) {
  const ProgramResult result = tagmint({"encode", "tag16h5", "0"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "tag16h5 id 0: 0x00000000000027c8\n" +
                            cli::cell_picture(codec::tag_cells(
                                codec::find_family("tag16h5")->layout(), codec::Codeword{0x27c8})));
}

TEST(Encode, JsonHoldsTheIdsInTheOrderOfTheArguments) {
  const ProgramResult result =
      tagmint({"encode", "tag16h5", "9", "2-4", "28-", "--format", "json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json.at("family"), "tag16h5");
  const codec::SharedFamily family = codec::find_family("tag16h5");
  std::vector<codec::TagId> ids;
  for (const Json& tag : json.at("tags")) {
    const codec::TagId id = tag.at("id");
    ids.push_back(id);
    EXPECT_EQ(tag.at("code"), codec::to_hex(family->codeword(id)));
    EXPECT_EQ(tag.at("cells"), codec::tag_cells(family->layout(), family->codeword(id)).rows());
  }
  EXPECT_EQ(ids, (std::vector<codec::TagId>{9, 2, 3, 4, 28, 29}));
}

TEST(Encode, WrongIdsAreUsageErrors) {
  expect_fault({"encode", "tag16h5", "30"}, 2, "id 30 is not in the family (ID); its ids are 0-29");
  expect_fault({"encode", "tag16h5", "one"}, 2,
               "'one' in the id list 'one' is not an id (ID); write ids and ranges, like "
               "0-9,12,20-");
}

TEST(Decode, FindsIdErrorsAndRotation) {
  const codec::SharedFamily family = codec::find_family("tag36h11");
  const codec::Codeword seen = codec::rotate(family->codeword(7), 36, 1) ^ 0x11;
  const ProgramResult result = tagmint({"decode", "tag36h11", codec::to_hex(seen)});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, codec::to_hex(seen) + " id 7 hamming 2 rotation 3\n");
}

TEST(Decode, JsonTellsMatchesAndMisses) {
  const ProgramResult result =
      tagmint({"decode", "tag36h11", "0xD7E00984B", "0", "--format", "json"});
  EXPECT_EQ(result.exit_code, 0);
  const Json expected = {
      {"family", "tag36h11"},
      {"max_hamming", 2},
      {"results",
       {{{"code", "0x0000000d7e00984b"}, {"id", 0}, {"hamming", 0}, {"rotation", 0}},
        {{"code", "0x0000000000000000"}, {"id", nullptr}}}}};
  EXPECT_EQ(Json::parse(result.out), expected);
}

TEST(Decode, NothingMatchedIsTheAnswerNo) {
  const ProgramResult result = tagmint({"decode", "tag36h11", "0"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "0x0000000000000000 no tag\n");
  EXPECT_EQ(result.err, "");
}

TEST(Decode, RadiusIsTheOneAskedFor) {
  const std::string three_errors = codec::to_hex(0xd7e00984b ^ 0x111);
  EXPECT_EQ(tagmint({"decode", "tag36h11", three_errors}).exit_code, 1);
  EXPECT_EQ(tagmint({"decode", "tag36h11", three_errors, "--max-hamming", "3"}).out,
            three_errors + " id 0 hamming 3 rotation 0\n");
  EXPECT_EQ(tagmint({"decode", "tag36h11", three_errors, "--max-hamming", "0"}).exit_code, 1);
}

TEST(Decode, RadiusAboveTheSafeOneNeedsTheUsersWord) {
  expect_fault({"decode", "tag36h11", "0", "--max-hamming", "6"}, 2,
               "6 bit errors are more than the 5 that tag36h11 corrects safely with distance 11 "
               "(--max-hamming); ask for 0 to 5, or add --unsafe-radius");
  const std::string six_errors = codec::to_hex(0xd7e00984b ^ 0x111111);
  const ProgramResult result =
      tagmint({"decode", "tag36h11", six_errors, "--max-hamming", "6", "--unsafe-radius"});
  EXPECT_LE(result.exit_code, 1);
  EXPECT_EQ(result.err, "");
}

TEST(Decode, TheIdsInUseDecideTheSafeRadius) {
  const ScratchFolder folder;
  const codec::Family generated(generated_36());
  for (const codec::Family& family : {generated, listed(generated)}) {
    const std::string path = folder.file("levels.json");
    codec::write_family(family, path);
    const std::string seven_errors = codec::to_hex(family.codeword(59) ^ 0x111111100);
    // A level of 60 tags at distance 16, and a part of it.
    for (const std::string ids : {"0-59", "3,59"}) {
      const ProgramResult result =
          tagmint({"decode", path, seven_errors, "--ids", ids, "--max-hamming", "7"});
      EXPECT_EQ(result.exit_code, 0) << result.err;
      EXPECT_EQ(result.out, seven_errors + " id 59 hamming 7 rotation 0\n");
    }
    EXPECT_EQ(tagmint({"decode", path, seven_errors, "--ids", "0-58"}).exit_code, 1);
    expect_fault({"decode", path, "0", "--max-hamming", "7"}, 2,
                 "7 bit errors are more than the 3 that generated36 corrects safely with distance "
                 "8 (--max-hamming); ask for 0 to 3, or add --unsafe-radius");
    expect_fault({"decode", path, "0", "--max-hamming", "8", "--ids", "0-59"}, 2,
                 "8 bit errors are more than the 7 that ids 0-59 of generated36 correct safely "
                 "with distance 16 (--max-hamming); ask for 0 to 7, or add --unsafe-radius");
  }
}

TEST(Decode, RadiusBeyondAllBitsIsNamedWithItsOption) {
  expect_fault({"decode", "tag16h5", "0", "--max-hamming", "17", "--unsafe-radius"}, 2,
               "17 bit errors cannot be corrected in tag16h5 (--max-hamming); 0 to 16 can");
}

TEST(Decode, WhatIsNoCodewordIsAUsageError) {
  for (const char* text : {"xyz", "0x", "", "0xd7e00984bg", "+1"}) {
    expect_fault(
        {"decode", "tag36h11", "--", text}, 2,
        fmt::format("'{}' is not a codeword (CODE); write hex digits, like 0xd7e00984b", text));
  }
  for (const char* text : {"0x1000000000", "fffffffffffffffff"}) {
    expect_fault(
        {"decode", "tag36h11", text}, 2,
        fmt::format("'{}' has more than 36 bits (CODE); give a codeword of tag36h11", text));
  }
}

TEST(Family, NameThatIsNeitherBundledNorAFileGetsASuggestion) {
  for (const char* command : {"encode", "decode", "info", "check"}) {
    std::vector<std::string> words = {command, "tag36h1"};
    if (command == std::string("encode") || command == std::string("decode")) {
      words.push_back("0");
    }
    expect_fault(words, 3,
                 "no family 'tag36h1' is bundled and no file has that name; did you mean "
                 "'tag36h11'? `tagmint families` lists the bundled ones");
  }
}

TEST(Family, MalformedFileIsToldWithItsLine) {
  const ScratchFolder folder;
  const std::string file = folder.file("broken.json");
  write_file(file, "{\n  \"format\":\"tagmint-family\",\n  \"version\":1,\n  \"name\" 5\n}\n");
  const ProgramResult result = tagmint({"info", file});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.err.starts_with("tagmint: error: ")) << result.err;
  EXPECT_NE(result.err.find("(" + file + ":4)"), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1);
}

TEST(Family, FolderAsFileIsAnInputFault) {
  const ScratchFolder folder;
  EXPECT_EQ(tagmint({"info", folder.path().string()}).exit_code, 3);
}

}  // namespace
}  // namespace tagmint::test
