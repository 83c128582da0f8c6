// Families that were published before their search had ended: ours begins with the same codes and
// goes on to the end of the walk.

#include <gtest/gtest.h>

#include "support/lexicode_options.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/search/completeness.h"
#include "tagmint/codec/search/lexicode.h"

namespace tagmint::codec {
namespace {

using tagmint::testing::options_for;

/// That the bundled family begins with the published one is held by BuiltinFamilies.
void expect_made_again(const LexicodeOptions& options, const char* name) {
  const LexicodeResult result = search_lexicode(options);
  EXPECT_EQ(result.end, SearchEnd::Complete);
  EXPECT_EQ(family_digest(make_family(options, result)), family_digest(*find_family(name)));
}

TEST(CompletedLexicodes, Tag36h9xIsMadeAgain) {
  expect_made_again(options_for("classic:10", 9, "apriltag2", "rectangles:10"), "tag36h9x");
}

TEST(CompletedLexicodes, TagStandard41h12xIsMadeAgain) {
  expect_made_again(options_for("standard:9", 12, "apriltag3", "energy:0.3333"),
                    "tagStandard41h12x");
}

TEST(CompletedLexicodes, TagStandard41h12xIsProvenComplete) {
  const SharedFamily family = find_family("tagStandard41h12x");
  ASSERT_NE(family, nullptr);
  EXPECT_EQ(prove_complete(*family).addable, std::nullopt);
}

}  // namespace
}  // namespace tagmint::codec
