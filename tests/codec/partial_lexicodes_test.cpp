// Families that were published after a small part of their walk: the same words make them again.

#include <gtest/gtest.h>

#include <cstdint>

#include "support/lexicode_options.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/search/lexicode.h"
#include "tagmint/codec/search/search_state.h"

namespace tagmint::codec {
namespace {

using tagmint::testing::options_for;

/// `last` is the place in the walk of the last code published.
void expect_made_again(const char* name, std::uint64_t last) {
  const SharedFamily published = find_family(name);
  LexicodeOptions options = options_for(layout_name(published->layout()).c_str(),
                                        published->min_hamming(), "apriltag3", "energy:0.3333");
  SearchState state;
  options.step = [&](const SearchStep& step) { state.apply(step); };
  options.limit_words = last - 1;
  EXPECT_EQ(search_lexicode(options).codewords.size(), published->size() - 1) << name;

  options.limit_words = last;
  options.step = nullptr;
  const LexicodeResult result = search_lexicode(options, state);
  EXPECT_EQ(result.end, SearchEnd::LimitWords);
  EXPECT_EQ(result.words_searched, last);
  EXPECT_EQ(family_digest(make_family(options, result)), family_digest(*published)) << name;
}

TEST(PartialLexicodes, TagCustom48h12IsMadeAgain) {
  expect_made_again("tagCustom48h12", 3'427'504'706);
}

TEST(PartialLexicodes, TagCircle49h12IsMadeAgain) {
  expect_made_again("tagCircle49h12", 3'123'772'070);
}

TEST(PartialLexicodes, TagStandard52h13IsMadeAgain) {
  expect_made_again("tagStandard52h13", 2'807'965'426);
}

}  // namespace
}  // namespace tagmint::codec
