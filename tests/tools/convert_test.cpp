// `tagmint convert` as its users meet it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "support/generated_families.h"
#include "support/scratch_folder.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::test {
namespace {

namespace fs = std::filesystem;

/// What the program says on stderr when it succeeds.
std::string told(const std::vector<std::string>& words) {
  const ProgramResult result = tagmint(words);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  return result.err;
}

TEST(Convert, WritesEachKindByItsExtensionAndReadsItBackByItsContent) {
  const ScratchFolder folder;
  const codec::SharedFamily family = codec::find_family("tag16h5");
  for (const char* name : {"a.json", "a.c", "a.yml", "a.yaml.gz", "a.json.gz", "a.txt", "a.dict",
                           "a.csv", "tag16h5"}) {
    SCOPED_TRACE(name);
    told({"convert", "tag16h5", "-o", folder.file(name)});
    // The name says nothing any more.
    fs::rename(folder.file(name), folder.file("input"));
    told({"convert", folder.file("input"), "-o", folder.file("back.json")});
    const codec::Family back = codec::read_family(folder.file("back.json"));
    EXPECT_TRUE(std::ranges::equal(back.codewords(), family->codewords()));
    EXPECT_EQ(back.min_hamming(), 5);
    fs::remove_all(folder.file("input"));
  }
}

TEST(Convert, SaysWhatItWrote) {
  const ScratchFolder folder;
  EXPECT_EQ(told({"convert", "tag16h5", "-o", folder.file("a.h")}),
            fmt::format("tagmint: tag16h5: 30 codes as apriltag-c; written to {0}.h and {0}.c\n",
                        folder.file("a")));
  EXPECT_EQ(told({"convert", "tag16h5", "-o", folder.file("tags")}),
            fmt::format("tagmint: tag16h5: 30 codes as png; written to {}, 31 files\n",
                        folder.file("tags")));
  EXPECT_EQ(told({"convert", "tag16h5", "-o", folder.file("a.yml"), "--opencv", "5"}),
            fmt::format("tagmint: tag16h5: 30 codes as opencv, upright; written to {}\n",
                        folder.file("a.yml")));
  EXPECT_EQ(told({"convert", "tag16h5", "-o", folder.file("b.yml")}),
            fmt::format("tagmint: tag16h5: 30 codes as opencv, turned by 180 degrees as OpenCV 4's "
                        "own AprilTag dictionaries are; written to {}\n",
                        folder.file("b.yml")));
  EXPECT_EQ(told({"convert", "tag16h5", "--quiet", "-o", folder.file("b.csv")}), "");
}

TEST(Convert, FamilyThatIsTooLargeForLibapriltagIsCutAndThatIsSaid) {
  const ScratchFolder folder;
  EXPECT_EQ(
      told({"convert", "tagCustom48h12x", "-o", folder.file("a.c")}),
      fmt::format("tagmint: tagCustom48h12x: only the first 65535 of 80527 codes are written, "
                  "at distance 12; 14992 are left out: libapriltag holds no more\n"
                  "tagmint: tagCustom48h12x: 65535 codes as apriltag-c; written to {0}.h and "
                  "{0}.c\n",
                  folder.file("a")));
  const std::string source = read_file(folder.file("a.c"));
  EXPECT_NE(source.find("; the first 65535 of 80527 tags.\n"), std::string::npos);
  told({"convert", folder.file("a.c"), "-o", folder.file("back.json")});
  EXPECT_EQ(codec::read_family(folder.file("back.json")).size(), 65535U);
}

TEST(Convert, CodesLimitsAnyKind) {
  const ScratchFolder folder;
  EXPECT_EQ(told({"convert", "tag36h11", "--codes", "100", "-o", folder.file("a.csv")}),
            fmt::format("tagmint: tag36h11: only the first 100 of 587 codes are written, at "
                        "distance 11; 487 are left out: --codes asks for no more\n"
                        "tagmint: tag36h11: 100 codes as csv; written to {}\n",
                        folder.file("a.csv")));
  expect_fault({"convert", "tag36h11", "--codes", "588", "-o", folder.file("b.csv")}, 2,
               "tag36h11 has 587 codes, not 588 (--codes); ask for fewer");
  EXPECT_FALSE(fs::exists(folder.file("b.csv")));
}

TEST(Convert, CutToALevelHasTheDistanceOfThatLevel) {
  const ScratchFolder folder;
  std::string text = codec::format_family(*codec::find_family("tag16h5"));
  const std::string mark = "  \"sha256\"";
  text.insert(text.find(mark),
              "  \"levels\":[{\"codes\":2,\"min_hamming\":6},"
              "{\"codes\":30,\"min_hamming\":5}],\n");
  const std::string nested = folder.write("nested.json", text);
  told({"convert", nested, "--codes", "2", "-o", folder.file("a.c")});
  EXPECT_NE(read_file(folder.file("a.c")).find("tf->h = 6;"), std::string::npos);
  told({"convert", nested, "--codes", "3", "-o", folder.file("a.c")});
  EXPECT_NE(read_file(folder.file("a.c")).find("tf->h = 5;"), std::string::npos);
}

TEST(Convert, GeneratedFamilyIsListedWhereTheKindNeedsAList) {
  const ScratchFolder folder;
  const codec::Family family(generated_36());
  const std::string input = folder.file("large.json");
  codec::write_family(family, input);

  told({"convert", input, "-o", folder.file("same.json")});
  EXPECT_EQ(read_file(folder.file("same.json")), read_file(input));

  const std::string said = told({"convert", input, "-o", folder.file("a.c")});
  EXPECT_TRUE(said.starts_with(
      "tagmint: generated36: only the first 65535 of 130816 codes are written, at distance 8; "
      "65281 are left out: libapriltag holds no more\n"))
      << said;
  EXPECT_EQ(told({"convert", input, "-o", folder.file("a.dict")}),
            fmt::format("tagmint: generated36: 130816 codes as rmsalinas; written to {}\n",
                        folder.file("a.dict")));

  told({"convert", input, "--codes", "2016", "-o", folder.file("b.c")});
  told({"convert", folder.file("b.c"), "-o", folder.file("b.json")});
  const codec::Family part = codec::read_family(folder.file("b.json"));
  EXPECT_EQ(part.min_hamming(), 12);
  ASSERT_EQ(part.size(), 2016U);
  EXPECT_TRUE(part.is_listed());
  EXPECT_TRUE(std::ranges::equal(part.levels(), family.levels().first(2)));
  for (codec::TagId id = 0; id < part.size(); ++id) {
    ASSERT_EQ(part.codeword(id), family.codeword(id));
  }
}

TEST(Convert, NameOfTheFamilyCanBeChanged) {
  const ScratchFolder folder;
  told({"convert", "tag16h5", "--name", "lab", "-o", folder.file("a.json")});
  told({"convert", folder.file("a.json"), "--name", "tagLab", "-o", folder.file("a.c")});
  EXPECT_NE(read_file(folder.file("a.c")).find("*tagLab_create(void)"), std::string::npos);
  expect_fault({"convert", "tag16h5", "--name", "a b", "-o", folder.file("a.c")}, 2,
               "family name 'a b' is not possible; use letters, digits, '_', '-' and '.'");
}

TEST(Convert, WhatAKindCannotHoldIsRefusedWithTheReason) {
  const ScratchFolder folder;
  for (const auto& [file, kind] : {std::pair{"a.yml", "an OpenCV dictionary"},
                                   std::pair{"a.dict", "a rmsalinas dictionary"}}) {
    expect_fault({"convert", "tagStandard41h12", "-o", folder.file(file)}, 2,
                 fmt::format("{} holds full squares of data cells inside a one-cell black border "
                             "only, the layout of tagStandard41h12 is standard:9; use apriltag-c, "
                             "png, csv or tagmint",
                             kind));
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(Convert, GoesToStdoutWhereTheKindIsNamed) {
  const ProgramResult result = tagmint({"convert", "tag16h5", "--to", "rmsalinas", "-o", "-"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(result.out.starts_with("name tag16h5\nnbits 16\n")) << result.out;
  expect_fault({"convert", "tag16h5", "-o", "-"}, 2,
               "the name of the output does not tell its kind (-); name it with --to, one of png, "
               "tagmint, opencv, rmsalinas, csv, apriltag-c");
  expect_fault({"convert", "tag16h5", "--to", "apriltag-c", "-o", "-"}, 2,
               "apriltag-c is more than one file (-o); give it a name of its own");
}

TEST(Convert, OutputsThatCannotBeAreToldBeforeAnyWork) {
  const ScratchFolder folder;
  expect_fault({"convert", "tag16h5", "-o", folder.file("a.xml")}, 2,
               fmt::format("the name of the output does not tell its kind ({}); name it with --to, "
                           "one of png, tagmint, opencv, rmsalinas, csv, apriltag-c",
                           folder.file("a.xml")));
  expect_fault({"convert", "tag16h5", "--to", "opencw", "-o", folder.file("a")}, 2,
               "'opencw' is not possible (--to); did you mean 'opencv'? it is one of png, tagmint, "
               "opencv, rmsalinas, csv, apriltag-c");
  expect_fault({"convert", "tag16h5", "-o", folder.file("no/a.c")}, 4,
               fmt::format("cannot write: there is no folder {} ({}); make it first or choose "
                           "another place",
                           folder.file("no"), folder.file("no/a.c")));
  expect_fault({"convert", "tag16h5", "-o", folder.file("no/a")}, 4,
               fmt::format("cannot write: there is no folder {} ({}); make it first or choose "
                           "another place",
                           folder.file("no"), folder.file("no/a")));
}

TEST(Convert, FolderIsCompleteOrAbsent) {
  const ScratchFolder folder;
  const std::string tags = folder.file("tags");
  fs::create_directory(tags);
  told({"convert", "tag16h5", "-o", tags});  // an empty folder is taken
  EXPECT_EQ(folder.names(), std::vector<std::string>{"tags"});
  EXPECT_TRUE(fs::exists(tags + "/tag16_05_00029.png"));
  EXPECT_TRUE(fs::exists(tags + "/mosaic.png"));
  expect_fault({"convert", "tag25h9", "-o", tags}, 4,
               fmt::format("cannot make the folder: there is one with files in it ({}); remove it "
                           "or choose another name",
                           tags));
  EXPECT_FALSE(fs::exists(tags + "/tag25_09_00000.png"));
  expect_fault({"convert", "tag25h9", "--to", "png", "-o", folder.write("file", "x")}, 4,
               fmt::format("cannot make the folder: a file has that name ({}); remove it or choose "
                           "another name",
                           folder.file("file")));
}

TEST(Convert, InputThatIsNoFamilyIsToldInOneLine) {
  const ScratchFolder folder;
  expect_fault({"convert", "tag36h1", "-o", "x.c"}, 3,
               "no family 'tag36h1' is bundled and no file has that name; did you mean 'tag36h11'? "
               "`tagmint families` lists the bundled ones");
  expect_fault({"convert", "artolkitplus-bch", "-o", "x.c"}, 3,
               "no family 'artolkitplus-bch' is bundled and no file has that name; did you mean "
               "'artoolkitplus-bch'? `tagmint families` lists the bundled ones");
  const std::string text = folder.write("a.txt", "hello\n");
  expect_fault({"convert", text, "-o", folder.file("x.c")}, 3,
               fmt::format("no known kind of family file ({}); the kinds are png, tagmint, opencv, "
                           "rmsalinas, csv, apriltag-c; name the right one with --from",
                           text));
  const std::string empty = folder.write("b.txt", "");
  expect_fault({"convert", empty, "-o", folder.file("x.c")}, 3,
               fmt::format("the file is empty ({}); the kinds are png, tagmint, opencv, rmsalinas, "
                           "csv, apriltag-c; name the right one with --from",
                           empty));
  fs::create_directory(folder.file("none"));
  expect_fault({"convert", folder.file("none"), "-o", folder.file("x.c")}, 3,
               fmt::format("no picture of a tag is in this folder ({}); they are called like "
                           "tag36_11_00000.png",
                           folder.file("none")));
}

TEST(Convert, NamesThatFamiliesCannotHaveAreChangedAndThatIsSaid) {
  const ScratchFolder folder;
  const std::string file =
      folder.write("a b.txt", "name My tags (1)\nnbits 9\n110100111\n000110100\n");
  EXPECT_NE(told({"convert", file, "-o", folder.file("a.csv")})
                .find("tagmint: My_tags__1_: the file has another name, which cannot be that of a "
                      "family; see --name\n"),
            std::string::npos);
  told({"convert", folder.file("a.csv"), "--name", "mine", "-o", folder.file("b.json")});
  EXPECT_EQ(codec::read_family(folder.file("b.json")).name(), "mine");
}

TEST(Convert, WhatTheUserSaysReplacesTheNote) {
  const ScratchFolder folder;
  told({"convert", "tag16h5", "-o", folder.file("a.yml")});
  const std::string said =
      told({"convert", folder.file("a.yml"), "--min-hamming", "4", "-o", folder.file("a.json")});
  EXPECT_EQ(said.find("note"), std::string::npos) << said;
  EXPECT_EQ(codec::read_family(folder.file("a.json")).min_hamming(), 4);
}

TEST(Convert, OptionsThatContradictTheInputAreRefused) {
  expect_fault({"convert", "tag16h5", "--layout", "classic:8", "-o", "x.c"}, 2,
               "a tagmint family says all of itself; leave --layout out");
  expect_fault({"convert", "tag16h5", "--min-hamming", "4", "-o", "x.c"}, 2,
               "a tagmint family says all of itself; leave --min-hamming out");
}

}  // namespace
}  // namespace tagmint::test
