// The published families, made again by the search, code by code in the order of their ids.

#include <gtest/gtest.h>

#include <string>

#include "search/engines.h"
#include "support/lexicode_options.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/search/lexicode.h"

namespace tagmint::codec {
namespace {

using tagmint::testing::options_for;

/// Searches all words and compares with the SHA-256 of the published codes and the bundled family.
void expect_published(const LexicodeOptions& options, const LexicodeResult& result,
                      const std::string& name, const std::string& digest) {
  EXPECT_EQ(result.end, SearchEnd::Complete);
  const Family family = make_family(options, result);
  EXPECT_EQ(family.name(), name);
  EXPECT_EQ(family_digest(family), digest);
  const SharedFamily bundled = find_family(name);
  ASSERT_NE(bundled, nullptr);
  EXPECT_EQ(family_digest(*bundled), digest);
  EXPECT_EQ(family.layout(), bundled->layout());
}

TEST(PublishedLexicodes, Tag16h5IsMadeAgain) {
  const LexicodeOptions options = options_for("classic:8", 5, "apriltag2", "rectangles:5");
  expect_published(options, search_lexicode(options), "tag16h5",
                   "45a45497aedac455ec997c3d9696dcb51821fbb6a9a6dec9dfa8aee4408104fe");
}

TEST(PublishedLexicodes, TagCircle21h7IsMadeAgain) {
  const LexicodeOptions options = options_for("circle:9", 7, "apriltag3", "energy:0.3333");
  expect_published(options, search_lexicode(options), "tagCircle21h7",
                   "9f8e23cb793255bf29f9253cffc4397c946d8d4e26f307879177f380fd45fabe");
}

TEST(PublishedLexicodes, Tag25h9IsMadeAgainByTheWalkAndByTheTree) {
  const LexicodeOptions options = options_for("classic:9", 9, "apriltag2", "rectangles:8");
  const std::string digest = "dadb26e73ac986565287c3971e449727fd5d20493fc0a048d3162c2e0fd2620e";
  expect_published(options, search_plain(options), "tag25h9", digest);
  expect_published(options, search_by_tree(options), "tag25h9", digest);
}

TEST(PublishedLexicodes, Tag36h11IsMadeAgain) {
  const LexicodeOptions options = options_for("classic:10", 11, "apriltag2", "rectangles:10");
  expect_published(options, search_lexicode(options), "tag36h11",
                   "0fd3ab87dd37625dbc5044ae25a896224ad0ac6d33a4b1dac35aaa30820d54a5");
}

TEST(PublishedLexicodes, Tag36h10IsMadeAgain) {
  const LexicodeOptions options = options_for("classic:10", 10, "apriltag2", "rectangles:10");
  expect_published(options, search_lexicode(options), "tag36h10",
                   "39791000aed069e34b53df9d397573b655080e6391a30759ced3ff3c4a51931c");
}

}  // namespace
}  // namespace tagmint::codec
