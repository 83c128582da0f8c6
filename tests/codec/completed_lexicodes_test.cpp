// Families that were published before their search had ended: ours begins with the same codes and
// goes on to the end of the walk.

#include <gtest/gtest.h>

#include <string>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/search/completeness.h"
#include "tagmint/codec/search/lexicode.h"

namespace tagmint::codec {
namespace {

/// The digest of the first `codes` codes of a finished search.
std::string digest_of_first(const LexicodeOptions& options, LexicodeResult result,
                            std::size_t codes) {
  result.codewords.resize(codes);
  return family_digest(make_family(options, result));
}

TEST(CompletedLexicodes, Tag36h9BeginsWithThePublishedCodes) {
  const LexicodeOptions options{.layout = classic_layout(10),
                                .min_hamming = 9,
                                .order = parse_order("apriltag2"),
                                .complexity = parse_complexity("rectangles:10")};
  const LexicodeResult result = search_lexicode(options);
  EXPECT_EQ(result.end, SearchEnd::Complete);
  ASSERT_EQ(result.codewords.size(), 5368u);
  const SharedFamily published = find_family("tag36h9");
  ASSERT_NE(published, nullptr);
  EXPECT_EQ(published->size(), 5329u);
  EXPECT_EQ(digest_of_first(options, result, published->size()), family_digest(*published));
}

TEST(CompletedLexicodes, TagStandard41h12BeginsWithThePublishedCodes) {
  const LexicodeOptions options{.layout = standard_layout(9),
                                .min_hamming = 12,
                                .order = parse_order("apriltag3"),
                                .complexity = parse_complexity("energy:0.3333")};
  const LexicodeResult result = search_lexicode(options);
  EXPECT_EQ(result.end, SearchEnd::Complete);
  ASSERT_EQ(result.codewords.size(), 2202u);
  const SharedFamily published = find_family("tagStandard41h12");
  ASSERT_NE(published, nullptr);
  EXPECT_EQ(published->size(), 2115u);
  EXPECT_EQ(digest_of_first(options, result, published->size()), family_digest(*published));
}

TEST(CompletedLexicodes, TagStandard41h12xIsProvenComplete) {
  const SharedFamily family = find_family("tagStandard41h12x");
  ASSERT_NE(family, nullptr);
  EXPECT_EQ(prove_complete(*family).addable, std::nullopt);
}

}  // namespace
}  // namespace tagmint::codec
