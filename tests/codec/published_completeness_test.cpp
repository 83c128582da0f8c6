// Which of the published families are complete.

#include <gtest/gtest.h>

#include <string>

#include "support/addable_word.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/search/completeness.h"

namespace tagmint::codec {
namespace {

using tagmint::testing::could_be_added;
using tagmint::testing::without;

TEST(PublishedCompleteness, SearchedToTheEnd) {
  for (const char* name :
       {"tag16h5", "tag25h9", "tag36h11", "tag36h10", "tag36h9x", "tagCircle21h7"}) {
    EXPECT_EQ(prove_complete(*find_family(name)).addable, std::nullopt) << name;
  }
}

void expect_incomplete(const Family& family) {
  const auto word = prove_complete(family).addable;
  ASSERT_TRUE(word) << family.name();
  EXPECT_TRUE(could_be_added(family, *word)) << family.name();
}

TEST(PublishedCompleteness, StoppedEarlier) {
  for (const char* name :
       {"tag36h9", "tagStandard41h12", "tagCustom48h12", "tagCircle49h12", "tagStandard52h13"}) {
    expect_incomplete(*find_family(name));
  }
}

TEST(PublishedCompleteness, EveryTagIsMissed) {
  expect_incomplete(without(*find_family("tag25h9"), 12));
  expect_incomplete(without(*find_family("tag36h11"), 586));
}

}  // namespace
}  // namespace tagmint::codec
