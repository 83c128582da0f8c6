#include "tagmint/codec/builtin_families.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "support/places.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::codec {
namespace {

constexpr const char* kCustom48 =
    "custom:dddddddddd/dbbbbbbbbd/dbwwwwwwbd/dbwddddwbd/dbwdxxdwbd/"
    "dbwdxxdwbd/dbwddddwbd/dbwwwwwwbd/dbbbbbbbbd/dddddddddd";

/// What was published, and the completed ones; with the SHA-256 over the codewords in id order.
struct Bundled {
  const char* name;
  const char* layout;
  int min_hamming;
  std::size_t codes;
  const char* complexity;
  const char* seed;
  const char* digest;
};

// clang-format off
const std::vector<Bundled> kBundled = {
    {"tag16h5", "classic:8", 5, 30, "rectangles:5", "160505", "45a45497aedac455ec997c3d9696dcb51821fbb6a9a6dec9dfa8aee4408104fe"},
    {"tag25h9", "classic:9", 9, 35, "rectangles:8", "250908", "dadb26e73ac986565287c3971e449727fd5d20493fc0a048d3162c2e0fd2620e"},
    {"tag36h11", "classic:10", 11, 587, "rectangles:10", "361110", "0fd3ab87dd37625dbc5044ae25a896224ad0ac6d33a4b1dac35aaa30820d54a5"},
    {"tag36h10", "classic:10", 10, 2320, "rectangles:10", "361010", "39791000aed069e34b53df9d397573b655080e6391a30759ced3ff3c4a51931c"},
    {"tag36h9", "classic:10", 9, 5329, "rectangles:10", "360910", "b6c19d9d86cf283ec64472da66ce51dec2884fe13c372c439b2e202ea7d5b954"},
    {"tag36h9x", "classic:10", 9, 5368, "rectangles:10", "360910", "b7eae34923aaf88ccc8427d6ec63fbd29042f3bd8cc95eb8b4592e6f1f96ccb8"},
    {"tagCircle21h7", "circle:9", 7, 38, "energy:0.3333", "210710", "9f8e23cb793255bf29f9253cffc4397c946d8d4e26f307879177f380fd45fabe"},
    {"tagStandard41h12", "standard:9", 12, 2115, "energy:0.3333", "411210", "7aaf3b82b972b998213e0a276d90f7fb62145fb91644c5f8bbcda064fdcef330"},
    {"tagStandard41h12x", "standard:9", 12, 2202, "energy:0.3333", "411210", "d822e092f296d7a862f26fb1ef0665c17ef5a35b76bf8d9eb43380451b1a37e2"},
    {"tagCustom48h12", kCustom48, 12, 42211, "energy:0.3333", "481212", "9d3a60a3cef124c9a8736091ffba614cc76cac62efcd2941e0ce0a3d0d39d37d"},
    {"tagCustom48h12x", kCustom48, 12, 80527, "energy:0.3333", "481212", "fc5b776cfb79843768b968045db259d2c2bd776d3a47ab33f39fe7aa521769d0"},
    {"tagCircle49h12", "circle:11", 12, 65535, "energy:0.3333", "491215", "c78c4e42eee0a55f58fc736aa2ed52c8c4d9d92a28f3870c768da98221ff55be"},
    {"tagStandard52h13", "standard:10", 13, 48714, "energy:0.3333", "521312", "2a30908ae33cfd4df11ccdc80b4d08177914a629dcabed964f39ce7c7d6952c9"},
};
// clang-format on

/// Asked for while objects of other files are still being made.
const std::size_t kSizeBeforeMain = find_family("tagCustom48h12")->size();

TEST(BuiltinFamilies, AreThereBeforeMain) { EXPECT_EQ(kSizeBeforeMain, 42211u); }

TEST(BuiltinFamilies, BeginWithThePublishedAndTheCompletedOnes) {
  ASSERT_GE(family_names().size(), kBundled.size());
  for (std::size_t i = 0; i < kBundled.size(); ++i) {
    const Bundled& bundled = kBundled[i];
    EXPECT_EQ(family_names()[i], bundled.name);
    const SharedFamily family = find_family(bundled.name);
    ASSERT_NE(family, nullptr) << bundled.name;
    EXPECT_EQ(family->name(), bundled.name);
    EXPECT_EQ(layout_name(family->layout()), bundled.layout);
    EXPECT_EQ(family->min_hamming(), bundled.min_hamming);
    EXPECT_EQ(family->size(), bundled.codes);
    EXPECT_EQ(to_string(family->complexity()), bundled.complexity);
    EXPECT_EQ(family->origin().seed, bundled.seed);
    EXPECT_EQ(family_digest(*family), bundled.digest) << bundled.name;
  }
}

TEST(BuiltinFamilies, CompletedOnesBeginWithThePublishedCodes) {
  int completed = 0;
  for (const std::string& name : family_names()) {
    if (!name.ends_with('x')) continue;
    ++completed;
    const SharedFamily whole = find_family(name);
    const SharedFamily published = find_family(name.substr(0, name.size() - 1));
    ASSERT_NE(published, nullptr) << name;
    EXPECT_EQ(whole->layout(), published->layout());
    EXPECT_EQ(whole->min_hamming(), published->min_hamming());
    ASSERT_GT(whole->size(), published->size());
    EXPECT_TRUE(
        std::ranges::equal(whole->codewords().first(published->size()), published->codewords()));
  }
  EXPECT_EQ(completed, 3);
}

TEST(BuiltinFamilies, AreTheFilesOfTheFolder) {
  const std::filesystem::path folder = test::source_folder() / "families";
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    ++files;
    const SharedFamily family = find_family(entry.path().stem().string());
    ASSERT_NE(family, nullptr) << entry.path() << " is not compiled in";
  }
  EXPECT_EQ(files, family_names().size());
}

TEST(BuiltinFamilies, ObeyTheirComplexityRule) {
  for (const std::string& name : family_names()) {
    if (name.starts_with("rot")) continue;  // bundled_rotation_codes_test.cpp: some are plain
    const SharedFamily family = find_family(name);
    const ComplexityJudge judge(family->layout(), family->complexity());
    const std::size_t step = family->size() > 3000 ? 50 : 1;
    for (std::size_t id = 0; id < family->size(); id += step) {
      EXPECT_TRUE(judge.accepts(family->codeword(static_cast<TagId>(id)))) << name << " " << id;
    }
  }
}

TEST(BuiltinFamilies, AreParsedOnceAndShared) {
  std::vector<SharedFamily> seen(8);
  {
    std::vector<std::jthread> threads;
    for (SharedFamily& slot : seen) {
      threads.emplace_back([&slot] { slot = find_family("tag36h11"); });
    }
  }
  for (const SharedFamily& family : seen) EXPECT_EQ(family, seen.front());
}

TEST(BuiltinFamilies, UnknownNamesGiveNothing) {
  EXPECT_EQ(find_family("tag36h12"), nullptr);
  EXPECT_EQ(find_family("TAG36H11"), nullptr);
  EXPECT_EQ(find_family(""), nullptr);
}

TEST(LoadFamily, TakesNamesAndPaths) {
  EXPECT_EQ(load_family("tag16h5"), find_family("tag16h5"));
  const std::string path = (test::source_folder() / "families" / "tag25h9.json").string();
  EXPECT_EQ(load_family(path)->name(), "tag25h9");
}

TEST(LoadFamily, SuggestsTheNearestName) {
  try {
    load_family("tag36h1");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "no family 'tag36h1' is bundled and no file has that name; did you mean "
                 "'tag36h11'? `tagmint families` lists the bundled ones");
  }
}

}  // namespace
}  // namespace tagmint::codec
