#include <fmt/format.h>
#include <gtest/gtest.h>

#include <csignal>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "support/addable_word.h"
#include "support/generated_families.h"
#include "support/scratch_folder.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::test {
namespace {

using Json = nlohmann::json;

TEST(Check, PrintsWhatItProved) {
  const ProgramResult result = tagmint({"check", "tag36h11"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find(
                "tag36h11: proven: all 587 tags are at least 11 bits apart in every rotation"),
            std::string::npos)
      << result.out;
  EXPECT_EQ(result.out.find("VIOLATION"), std::string::npos);
}

TEST(Check, ViolationIsTheAnswerNo) {
  const ScratchFolder folder;
  const codec::SharedFamily good = codec::find_family("tag16h5");
  std::vector<codec::Codeword> codewords(good->codewords().begin(), good->codewords().end());
  codewords[3] = codewords[1] ^ 1;  // one bit from tag 1
  codec::FamilyParts parts{"broken", good->layout(), 5, codewords, {}, {}, {}};
  codec::write_family(codec::Family(std::move(parts)), folder.file("broken.json"));
  const ProgramResult result = tagmint({"check", folder.file("broken.json")});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("broken: VIOLATION: tags 1 and 3 are 1 bit apart"), std::string::npos)
      << result.out;
  EXPECT_EQ(result.err, "");
}

TEST(Check, CompletenessIsProvenOrAWordTold) {
  const ProgramResult whole = tagmint({"check", "tag16h5", "--complete"});
  EXPECT_EQ(whole.exit_code, 0);
  EXPECT_TRUE(
      whole.out.ends_with("tag16h5: proven: complete, none of all 2^16 words could be added\n"))
      << whole.out;
  EXPECT_TRUE(whole.out.starts_with(tagmint({"check", "tag16h5"}).out));

  const ScratchFolder folder;
  const codec::Family part = tagmint::testing::without(*codec::find_family("tag16h5"), 11);
  codec::write_family(part, folder.file("part.json"));
  const ProgramResult result = tagmint({"check", folder.file("part.json"), "--complete"});
  EXPECT_EQ(result.exit_code, 1);
  const std::string told = "tag16h5: VIOLATION: not complete, 0x";
  const std::size_t at = result.out.find(told);
  ASSERT_NE(at, std::string::npos) << result.out;
  const codec::Codeword word = std::stoull(result.out.substr(at + told.size(), 16), nullptr, 16);
  EXPECT_TRUE(tagmint::testing::could_be_added(part, word)) << result.out;
  for (const char* threads : {"1", "3"}) {
    EXPECT_EQ(tagmint({"check", folder.file("part.json"), "--complete", "--threads", threads}).out,
              result.out);
  }
}

TEST(Check, FamilyThatFailsIsNotAskedForCompleteness) {
  const ScratchFolder folder;
  const codec::SharedFamily good = codec::find_family("tag16h5");
  std::vector<codec::Codeword> codewords(good->codewords().begin(), good->codewords().end());
  codewords[3] = codewords[1] ^ 1;
  codec::FamilyParts parts{"broken", good->layout(), 5, codewords, {}, {}, {}};
  codec::write_family(codec::Family(std::move(parts)), folder.file("broken.json"));
  EXPECT_EQ(tagmint({"check", folder.file("broken.json"), "--complete"}).out,
            tagmint({"check", folder.file("broken.json")}).out);
}

TEST(Check, InterruptedProofProvesNothing) {
  RunningProgram program(
      tagmint_words({"check", "tagStandard41h12x", "--complete", "--progress=json"}));
  ASSERT_TRUE(program.wait_for_stderr("{\"task\":\"proof\",\"unit\":\"words\""));
  program.send_signal(SIGINT);
  const ProgramResult result = program.finish();
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.err.ends_with("tagmint: error: interrupted; nothing was proven\n"))
      << result.err;
}

TEST(Check, ResultDoesNotDependOnTheNumberOfThreads) {
  EXPECT_EQ(tagmint({"check", "tag36h10", "--threads", "1"}).out,
            tagmint({"check", "tag36h10", "--threads", "3"}).out);
}

TEST(Info, JsonHoldsTheFiguresOfTheFamily) {
  const ProgramResult result = tagmint({"info", "tag16h5", "--format", "json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json.at("codes"), 30);
  EXPECT_EQ(json.at("min_hamming"), 5);
  EXPECT_EQ(json.at("true_min_hamming"), 5);
  EXPECT_EQ(json.at("sha256"), codec::family_digest(*codec::find_family("tag16h5")));
  std::uint64_t pairs = 0;
  for (const Json& bar : json.at("distance_histogram")) pairs += bar.at("pairs").get<int>();
  EXPECT_EQ(pairs, 30U * 29 / 2);
  std::uint64_t tags = 0;
  for (const Json& bar : json.at("complexity_histogram")) {
    EXPECT_GE(bar.at("rectangles").get<double>(), 5);
    tags += bar.at("tags").get<int>();
  }
  EXPECT_EQ(tags, 30U);
  EXPECT_DOUBLE_EQ(json.at("false_accept_rate")[1].at("rate").get<double>(), 4 * 30 * 17 / 65536.0);
}

TEST(Info, LookupMemoryIsThatOfTheDecoders) {
  const codec::SharedFamily family = codec::find_family("tag25h9");
  const Json json = Json::parse(tagmint({"info", "tag25h9", "--format", "json"}).out);
  std::size_t rows = 0;
  for (const Json& row : json.at("lookup")) {
    codec::DecoderOptions options;
    options.max_errors = row.at("max_errors").get<int>();
    options.engine =
        row.at("engine") == "hash" ? codec::DecoderEngine::Hash : codec::DecoderEngine::Chunks;
    EXPECT_EQ(row.at("bytes"), codec::Decoder(family, options).table_bytes());
    ++rows;
  }
  EXPECT_EQ(rows, 3U + 5U);  // hash for 0 to 2 errors, chunks for 0 to 4
}

TEST(Info, LookupMemoryOfGeneratedFamiliesIsThatOfInformationSets) {
  const ScratchFolder folder;
  const auto family = std::make_shared<const codec::Family>(generated_25());
  codec::write_family(*family, folder.file("coset.json"));
  const Json json =
      Json::parse(tagmint({"info", folder.file("coset.json"), "--format", "json"}).out);
  ASSERT_EQ(json.at("lookup").size(), 5U);  // for 0 to 4 errors
  for (const Json& row : json.at("lookup")) {
    codec::DecoderOptions options;
    options.max_errors = row.at("max_errors").get<int>();
    EXPECT_EQ(row.at("engine"), "information-sets");
    EXPECT_EQ(row.at("bytes"), codec::Decoder(family, options).table_bytes());
  }
}

TEST(Info, TextNamesEverySection) {
  const std::string text = tagmint({"info", "tagCircle21h7"}).out;
  for (const char* part :
       {"tagCircle21h7", "codes", "safe radius   3 bit errors", "own turns     8 bits", "circle:9",
        "Pairs of tags by Hamming distance", "own turns", "Tags by complexity (energy)",
        "False-accept rate", "Memory of the lookup"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

TEST(Info, ResultDoesNotDependOnTheNumberOfThreads) {
  EXPECT_EQ(tagmint({"info", "tag36h10", "--threads", "1"}).out,
            tagmint({"info", "tag36h10", "--threads", "3"}).out);
}

TEST(Info, NamesTheNearestTags) {
  const Json json = Json::parse(tagmint({"info", "tag36h11", "--format", "json"}).out);
  EXPECT_EQ(json.at("distance_between_tags"), 11);
  EXPECT_EQ(json.at("self_distance"), 12);
  ASSERT_EQ(json.at("nearest_pairs").size(), 3U);
  EXPECT_EQ(json.at("nearest_pairs")[0].at("ids"), (Json{0, 8}));
  EXPECT_EQ(json.at("nearest_pairs")[0].at("distance"), 11);
  const std::string text = tagmint({"info", "tag36h11"}).out;
  EXPECT_NE(text.find("11 bits: 0 and 8, 0 and 56, 0 and 85, ... of 7191 pairs"), std::string::npos)
      << text;
}

TEST(Info, AmbiguousFamilyHasNoSafeRadius) {
  const ProgramResult result = tagmint({"info", "aruco-original", "--format", "json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_TRUE(json.at("safe_radius").is_null());
  EXPECT_EQ(json.at("true_min_hamming"), 0);
  EXPECT_NE(tagmint({"info", "aruco-original"}).out.find("safe radius   none:"), std::string::npos);
}

TEST(Info, AndCheckReadEveryKind) {
  const ScratchFolder folder;
  const Json own = Json::parse(tagmint({"info", "tag25h9", "--format", "json"}).out);
  for (const char* name : {"f.c", "f.yml", "f.json.gz", "f.dict", "f.csv", "pictures"}) {
    const std::string file = folder.file(name);
    ASSERT_EQ(tagmint({"convert", "tag25h9", "-o", file}).exit_code, 0);
    const ProgramResult result = tagmint({"info", file, "--format", "json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json read = Json::parse(result.out);
    EXPECT_EQ(read.at("sha256"), own.at("sha256")) << name;
    EXPECT_EQ(read.at("distance_histogram"), own.at("distance_histogram")) << name;
    const ProgramResult check = tagmint({"check", file});
    EXPECT_EQ(check.exit_code, 0) << check.err;
    EXPECT_NE(check.out.find("all 35 tags are at least 9 bits apart"), std::string::npos) << name;
  }
  EXPECT_EQ(tagmint({"info", folder.file("f.dict"), "--from", "rmsalinas"}).exit_code, 0);
  expect_fault({"check", folder.file("f.dict"), "--from", "png"}, 2,
               "a file is not png (" + folder.file("f.dict") + "); leave --from out");
  expect_fault({"encode", folder.file("f.yml"), "0"}, 3,
               "this is not JSON: syntax error while parsing value - invalid literal (" +
                   folder.file("f.yml") +
                   ":1); a family file is one JSON object; `tagmint convert` makes one of other "
                   "programs' files");
  EXPECT_EQ(tagmint({"check", "artag"}).exit_code, 1);
  EXPECT_NE(
      tagmint({"check", "artag"}).out.find("VIOLATION: tag 682 is 0 bits from one of its own"),
      std::string::npos)
      << tagmint({"check", "artag"}).out;
}

TEST(Check, ProvesTheDistanceThatIsSaid) {
  const ProgramResult result = tagmint({"check", "artoolkitplus-bch", "--min-hamming", "9"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("artoolkitplus-bch: VIOLATION: tag"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("the family declares 9"), std::string::npos) << result.out;
  expect_fault({"check", "tag36h11", "--min-hamming", "9"}, 2,
               "a tagmint family says all of itself; leave --min-hamming out");
}

TEST(InfoPage, IsOneFileThatAsksForNothing) {
  const ScratchFolder folder;
  const std::string file = folder.file("page.html");
  const ProgramResult result = tagmint({"info", "rot16h5", "--html", file});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "tagmint: rot16h5: the page of 60 tags; written to " + file + "\n");
  const std::string page = read_file(file);
  for (const char* part :
       {"<!DOCTYPE html>", "default-src 'none'", "60 tags of 16 bits", "id=\"levels\"",
        "id=\"distances\"", "id=\"turns\"", "id=\"complexity\"", "id=\"accepts\"",
        "ids 0-2, distance 8", "Safe radius: 2.", "outer", "tagmint sheet rot16h5",
        "tagmint detect --family rot16h5", "id=\"tag-11\"", "</html>"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  for (const char* request : {"src=", "<link", "url(", "@import", "fetch(", "XMLHttp", "import("}) {
    EXPECT_EQ(page.find(request), std::string::npos) << request;
  }
  EXPECT_NE(page.find("\"listed\":60"), std::string::npos);
  EXPECT_EQ(tagmint({"info", "rot16h5", "--html", "-"}).out, page);
}

TEST(InfoPage, OfAForeignFileSaysHowToConvertIt) {
  const ScratchFolder folder;
  const std::string file = folder.file("some tags.yml");
  ASSERT_EQ(tagmint({"convert", "tag16h5", "--opencv", "5", "-o", file}).exit_code, 0);
  const ProgramResult result = tagmint({"info", file, "--html", "-"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("tagmint convert '" + file + "' -o tag16h5.json\n"), std::string::npos);
  EXPECT_NE(result.out.find("tagmint sheet tag16h5.json --edge 40mm"), std::string::npos);
}

TEST(InfoPage, BesideTextOrJson) {
  const ScratchFolder folder;
  const std::string file = folder.file("page.html");
  const ProgramResult both = tagmint({"info", "tag16h5", "--html", file, "--format", "json"});
  EXPECT_EQ(both.out, tagmint({"info", "tag16h5", "--format", "json"}).out);
  EXPECT_FALSE(read_file(file).empty());
  expect_fault({"info", "tag16h5", "--html", "-", "--format", "json"}, 2,
               "the page and the text cannot both go to stdout (--html); give one of them a file");
}

TEST(InfoPage, ThatCannotBeWrittenLeavesNothing) {
  const ScratchFolder folder;
  const std::string file = folder.file("missing/page.html");
  expect_fault({"info", "tag16h5", "--html", file}, 4,
               "cannot write: there is no folder " + folder.file("missing") + " (" + file +
                   "); make it first or choose another place");
  EXPECT_TRUE(folder.names().empty());
}

TEST(Chain, GeneratedFamilyGoesThroughCheckEncodeAndDecode) {
  const ScratchFolder folder;
  const std::string file = folder.file("my.json");
  ASSERT_EQ(
      tagmint({"generate", "--layout", "standard:7", "--min-hamming", "9", "-o", file}).exit_code,
      0);
  const codec::Family family = codec::read_family(file);
  EXPECT_EQ(family.name(), "tagStandard25h9");
  EXPECT_EQ(tagmint({"check", file}).exit_code, 0);
  const Json encoded = Json::parse(tagmint({"encode", file, "0-", "--format", "json"}).out);
  ASSERT_EQ(encoded.at("tags").size(), family.size());
  std::vector<std::string> decode = {"decode", file};
  std::string expected;
  for (const Json& tag : encoded.at("tags")) {
    decode.push_back(tag.at("code"));
    expected += fmt::format("{} id {} hamming 0 rotation 0\n", tag.at("code").get<std::string>(),
                            tag.at("id").get<int>());
  }
  EXPECT_EQ(tagmint(decode).out, expected);
}

}  // namespace
}  // namespace tagmint::test
