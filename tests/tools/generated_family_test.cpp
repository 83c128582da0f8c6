// The commands take a family whose codewords are generated as they take any other.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/generated_families.h"
#include "support/scratch_folder.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::test {
namespace {

using Json = nlohmann::json;

/// The file of a family of 130,816 tags in four levels.
std::string large_family(const ScratchFolder& folder) {
  const std::string file = folder.file("large.json");
  codec::write_family(codec::Family(generated_36()), file);
  return file;
}

TEST(GeneratedFamilyTools, AreEncodedAndDecoded) {
  const ScratchFolder folder;
  const std::string file = large_family(folder);
  const codec::Family family(generated_36());
  const Json encoded =
      Json::parse(tagmint({"encode", file, "0,59,60,130815", "--format", "json"}).out);
  ASSERT_EQ(encoded.at("tags").size(), 4U);
  std::string expected;
  std::vector<std::string> decode = {"decode", file};
  for (const Json& tag : encoded.at("tags")) {
    const codec::TagId id = tag.at("id").get<codec::TagId>();
    EXPECT_EQ(tag.at("code"), codec::to_hex(family.codeword(id)));
    decode.push_back(tag.at("code"));
    expected += fmt::format("{} id {} hamming 0 rotation 0\n", decode.back(), id);
  }
  EXPECT_EQ(tagmint(decode).out, expected);
  expect_fault({"encode", file, "130816"}, 2,
               "id 130816 is not in the family (ID); its ids are 0-130815");
}

TEST(GeneratedFamilyTools, ArePrinted) {
  const ScratchFolder folder;
  const ProgramResult result =
      tagmint({"sheet", large_family(folder) + ":30mm:0-3,130815", "-o", folder.file("sheet.svg")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("generated36: 5 tags"), std::string::npos) << result.err;
}

TEST(GeneratedFamilyTools, AreRenderedAndDetected) {
  const ScratchFolder folder;
  const std::string file = large_family(folder);
  const std::string image = folder.file("scene.png");
  ASSERT_EQ(tagmint({"render", file, "--ids", "7,59,8127,130815", "-o", image}).exit_code, 0);
  const ProgramResult result = tagmint({"detect", "--family", file, "--format", "jsonl", image});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::vector<int> ids;
  const Json found = Json::parse(result.out);
  for (const Json& tag : found.at("detections")) {
    EXPECT_EQ(tag.at("family"), "generated36");
    ids.push_back(tag.at("id"));
  }
  EXPECT_EQ(ids, (std::vector<int>{7, 59, 8127, 130815}));
}

TEST(GeneratedFamilyTools, AreCheckedFromTheirCode) {
  const ScratchFolder folder;
  const std::string file = large_family(folder);
  const ProgramResult result = tagmint({"check", file});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* line :
       {"generated36: proven: the 19 words of the basis are independent\n",
        "generated36: proven: the first 60 tags are at least 16 bits apart in every rotation",
        "generated36: proven: the SHA-256 of all 130816 codewords is the declared one\n"}) {
    EXPECT_NE(result.out.find(line), std::string::npos) << line << result.out;
  }
  std::string text = read_file(file);
  const std::string digest = text.substr(text.find("\"sha256\":\"") + 10, 64);
  text.replace(text.find(digest), 64, std::string(64, 'a'));
  const ProgramResult broken = tagmint({"check", folder.write("broken.json", text)});
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_NE(broken.out.find("VIOLATION: the SHA-256 of the codewords is " + digest),
            std::string::npos)
      << broken.out;
}

TEST(GeneratedFamilyTools, InfoTellsEachLevel) {
  const ScratchFolder folder;
  const std::string file = large_family(folder);
  const Json json = Json::parse(tagmint({"info", file, "--format", "json"}).out);
  EXPECT_EQ(json.at("codes"), 130816);
  EXPECT_EQ(json.at("true_min_hamming"), 8);
  EXPECT_FALSE(json.contains("distance_histogram"));
  double words = 0;
  for (const Json& bar : json.at("word_distances")) words += bar.at("words").get<double>();
  EXPECT_EQ(words, 1 << 19);
  ASSERT_EQ(json.at("levels").size(), 4U);
  const Json& level = json.at("levels")[1];
  EXPECT_EQ(level.at("codes"), 2016);
  EXPECT_EQ(level.at("min_hamming"), 12);
  EXPECT_EQ(level.at("plain"), 132);
  EXPECT_EQ(level.at("true_min_hamming"), 12);
  EXPECT_EQ(level.at("safe_radius"), 5);
  EXPECT_EQ(level.at("passing"), 1884);
  ASSERT_EQ(level.at("false_accept_rate").size(), 6U);
  EXPECT_DOUBLE_EQ(level.at("false_accept_rate")[1].at("rate").get<double>(),
                   4.0 * 2016 * 37 / 68719476736.0);

  const std::string text = tagmint({"info", file}).out;
  for (const char* part :
       {"complexity    energy:0.3333; 121100 of 130816 tags pass\n",
        "Levels, with the false-accept rate of random words by corrected bits\n",
        "       ids    tags  distance  found  safe radius  at 0 bits  at 2 bits  at the safe radius"
        "  pass complexity\n",
        "    0-2015    2016        12     12            5",
        "Words of the code by Hamming distance from one of them; each turn of a tag is a word\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << text;
  }
}

TEST(GeneratedFamilyTools, FaultsOfTheirFilesAreInputErrors) {
  const ScratchFolder folder;
  std::string text = codec::format_family(codec::Family(generated_16()));
  const std::string basis = "0x0000000000005555";
  text.replace(text.find(basis), basis.size(), "0x0000000000005557");
  const std::string file = folder.write("broken.json", text);
  expect_fault({"encode", file, "0"}, 3,
               "level 0 is not closed under turns: the turn of basis word 0 (0x0000000000005557) "
               "is no sum of its 2 basis words (" +
                   file + ":24); correct this line or make the file anew");
}

}  // namespace
}  // namespace tagmint::test
