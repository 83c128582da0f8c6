// Every kind of family file, written and read back.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "io/family_kinds/family_changes.h"
#include "io/family_kinds/family_kind.h"
#include "support/scratch_folder.h"
#include "support/test_families.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::io {
namespace {

using codec::Family;

const FamilyKind& kind_named(std::string_view name) {
  const FamilyKind* const kind = find_family_kind(name);
  EXPECT_NE(kind, nullptr) << name;
  return *kind;
}

/// The family after it was written as that kind and read again; the kind is seen from the content.
ReadFamily there_and_back(const Family& family, const FamilyKind& kind,
                          const std::string& file_name = "out",
                          const FamilyWriteOptions& options = {}) {
  const test::ScratchFolder folder;
  const std::string target = folder.file(file_name);
  const std::vector<FamilyFile> files = kind.make(family, target, options);
  write_family_files(kind, target, files);
  const FamilySource source = read_family_source(kind.is_folder ? target : files.back().path);
  EXPECT_EQ(recognise_family_kind(source).name, kind.name);
  return kind.read(source, {});
}

/// Families of all looks: bundled ones, cut short, and layouts that nobody has published.
std::vector<Family> sample_families(std::size_t most_codes) {
  std::vector<Family> families;
  for (const std::string& name : codec::family_names()) {
    const codec::SharedFamily family = codec::find_family(name);
    families.push_back(first_tags(*family, std::min<std::size_t>(family->size(), most_codes)));
  }
  for (const char* layout :
       {"classic:6", "classic:7", "classic:11", "classic:12", "standard:7", "standard:8",
        "circle:8", "circle:10",
        "custom:xddddddx/dbbbbbbd/dbwwwwbd/dbwxxwbd/dbwxxwbd/dbwwwwbd/dbbbbbbd/xddddddx",
        "custom:wwwwwwwww/wbbbbbbbw/wbbbbbbbw/wbbdddbbw/wbbdddbbw/wbbdddbbw/wbbbbbbbw/wbbbbbbbw/"
        "wwwwwwwww"}) {
    families.push_back(*test::arbitrary_family(layout, 14));
  }
  return families;
}

bool is_square(const codec::Layout& layout) {
  return codec::layout_name(layout).starts_with("classic");
}

TEST(FamilyKinds, TagmintAndAprilTagCKeepEverything) {
  for (const Family& family : sample_families(3000)) {
    SCOPED_TRACE(family.name() + " " + codec::layout_name(family.layout()));
    for (const char* name : {"tagmint", "apriltag-c"}) {
      const ReadFamily back = there_and_back(family, kind_named(name));
      EXPECT_EQ(codec::format_family(back.family), codec::format_family(family)) << name;
      EXPECT_TRUE(back.notes.empty());
    }
  }
}

TEST(FamilyKinds, OpenCvKeepsEverythingOfClassicLayoutsInEitherTurn) {
  for (const Family& family : sample_families(3000)) {
    if (!is_square(family.layout())) continue;
    for (const char* file : {"a.yml", "a.yaml", "a.json", "a.yml.gz", "a.json.gz"}) {
      for (const OpenCvTurn turn : {OpenCvTurn::HalfTurned, OpenCvTurn::Upright}) {
        const ReadFamily back =
            there_and_back(family, kind_named("opencv"), file, {.opencv = turn});
        EXPECT_EQ(codec::format_family(back.family), codec::format_family(family))
            << family.name() << " " << file;
        EXPECT_TRUE(back.notes.empty());
      }
    }
  }
}

TEST(FamilyKinds, PngCsvAndRmsalinasKeepLayoutAndCodewords) {
  for (const Family& family : sample_families(100)) {
    SCOPED_TRACE(family.name() + " " + codec::layout_name(family.layout()));
    for (const char* name : {"png", "csv", "rmsalinas"}) {
      if (name == std::string("rmsalinas") && !is_square(family.layout())) continue;
      const Family back = there_and_back(family, kind_named(name)).family;
      EXPECT_EQ(back.layout(), family.layout()) << name;
      EXPECT_TRUE(std::ranges::equal(back.codewords(), family.codewords())) << name;
    }
  }
}

TEST(FamilyKinds, DistanceThatAKindLacksIsComputed) {
  const Family family = first_tags(*codec::find_family("tag36h11"), 50);
  for (const char* name : {"csv", "rmsalinas"}) {
    const ReadFamily back = there_and_back(family, kind_named(name));
    EXPECT_GE(back.family.min_hamming(), 11) << name;
    ASSERT_EQ(back.notes.size(), 1U);
    EXPECT_EQ(back.notes[0], "the distance is " + std::to_string(back.family.min_hamming()) +
                                 ", computed from the codewords");
  }
  EXPECT_EQ(there_and_back(family, kind_named("png"), "a").family.min_hamming(), 11);
}

TEST(FamilyKinds, WhatIsNoFullSquareIsRefusedWithTheReason) {
  const codec::SharedFamily family = codec::find_family("tagStandard41h12");
  for (const char* name : {"opencv", "rmsalinas"}) {
    try {
      kind_named(name).make(*family, "x", {});
      FAIL() << name;
    } catch (const std::invalid_argument& fault) {
      const std::string text = fault.what();
      EXPECT_NE(text.find("full squares of data cells inside a one-cell black border only"),
                std::string::npos);
      EXPECT_NE(text.find("standard:9"), std::string::npos);
    }
  }
}

TEST(FamilyKinds, OutputsAreRecognisedByTheirExtension) {
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"a.json", "tagmint"},   {"dir.x/A.JSON", "tagmint"},
      {"a.c", "apriltag-c"},   {"a.h", "apriltag-c"},
      {"a.yml", "opencv"},     {"a.yaml", "opencv"},
      {"a.yml.gz", "opencv"},  {"a.json.gz", "opencv"},
      {"a.csv", "csv"},        {"a.txt", "rmsalinas"},
      {"a.dict", "rmsalinas"}, {"a", "png"},
      {"dir.x/a", "png"},      {"a/", "png"}};
  for (const auto& [target, name] : expected) {
    const FamilyKind* const kind = family_kind_of_output(target);
    ASSERT_NE(kind, nullptr) << target;
    EXPECT_EQ(kind->name, name) << target;
  }
  EXPECT_EQ(family_kind_of_output("a.xml"), nullptr);
  EXPECT_EQ(family_kind_of_output("a.gz"), nullptr);
}

/// Reads what may be spoilt: a family or one of the faults that are told in one line.
void read_or_refuse(const FamilyKind& kind, const std::string& content) {
  const FamilySource source{.path = "x", .name = "x", .content = content};
  try {
    kind.read(source, {.threads = 1});
  } catch (const codec::InputError& fault) {
    EXPECT_EQ(std::string(fault.what()).find('\n'), std::string::npos) << fault.what();
    EXPECT_NE(std::string(fault.what()).find("(x"), std::string::npos) << fault.what();
  }
}

TEST(FamilyKinds, SpoiltFilesAreReadOrRefusedButNeverHarm) {
  const Family family = first_tags(*codec::find_family("tag16h5"), 8);
  for (const auto& [name, file] : {std::pair{"tagmint", "a.json"}, std::pair{"apriltag-c", "a.c"},
                                   std::pair{"opencv", "a.yml"}, std::pair{"opencv", "a.json"},
                                   std::pair{"rmsalinas", "a.txt"}, std::pair{"csv", "a.csv"}}) {
    SCOPED_TRACE(file);
    const FamilyKind& kind = kind_named(name);
    const std::string whole = kind.make(family, file, {}).back().content;
    for (std::size_t length = 0; length < whole.size(); ++length) {
      read_or_refuse(kind, whole.substr(0, length));
    }
    for (std::size_t at = 0; at < whole.size(); ++at) {
      for (const char c : {'0', '9', '"', '{', '\n', '\\', '\0', '\xff'}) {
        std::string spoilt = whole;
        spoilt[at] = c;
        read_or_refuse(kind, spoilt);
      }
    }
  }
}

TEST(FirstTags, TakeTheDistanceOfTheSmallestLevelThatHoldsThem) {
  const codec::SharedFamily flat = test::arbitrary_family("classic:9", 10);
  const Family nested({.name = "nested",
                       .layout = flat->layout(),
                       .min_hamming = 2,
                       .codewords = {flat->codewords().begin(), flat->codewords().end()},
                       .complexity = {},
                       .origin = {},
                       .levels = {{2, 9}, {5, 6, 1}, {10, 2, 3}}});
  const auto levels = [&](std::size_t codes) {
    const Family part = first_tags(nested, codes);
    EXPECT_EQ(part.size(), codes);
    EXPECT_EQ(part.min_hamming(), part.levels().back().min_hamming);
    return std::vector<codec::Level>(part.levels().begin(), part.levels().end());
  };
  using Levels = std::vector<codec::Level>;
  EXPECT_EQ(levels(1), (Levels{{1, 9}}));
  EXPECT_EQ(levels(2), (Levels{{2, 9}}));
  EXPECT_EQ(levels(3), (Levels{{2, 9}, {3, 6}}));
  EXPECT_EQ(levels(5), (Levels{{2, 9}, {5, 6, 1}}));
  EXPECT_EQ(levels(6), (Levels{{2, 9}, {5, 6, 1}, {6, 2}}));
  EXPECT_EQ(levels(9), (Levels{{2, 9}, {5, 6, 1}, {9, 2, 2}}));
  EXPECT_EQ(levels(10), (Levels{{2, 9}, {5, 6, 1}, {10, 2, 3}}));
}

}  // namespace
}  // namespace tagmint::io
