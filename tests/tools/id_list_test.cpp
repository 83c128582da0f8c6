#include "cli/id_list.h"

#include <gtest/gtest.h>

#include <string>

#include "cli/command.h"

namespace tagmint::cli {
namespace {

using Ids = std::vector<codec::TagId>;

std::string message_of(std::string_view text) {
  try {
    parse_id_list(text, 30);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(IdList, IdsAndRangesAreJoinedSortedAndUnique) {
  EXPECT_EQ(parse_id_list("7", 30), Ids({7}));
  EXPECT_EQ(parse_id_list("0-3,12,28-", 30), Ids({0, 1, 2, 3, 12, 28, 29}));
  EXPECT_EQ(parse_id_list("5,3,4-6,3", 30), Ids({3, 4, 5, 6}));
  EXPECT_EQ(parse_id_list(" 1 , 3 - 4 ", 30), Ids({1, 3, 4}));
}

TEST(IdList, OpenRangeRunsToTheLastId) {
  EXPECT_EQ(parse_id_list("0-", 30).size(), 30U);
  EXPECT_EQ(parse_id_list("29-", 30), Ids({29}));
}

TEST(IdList, IdOutsideTheFamilyIsNamed) {
  EXPECT_EQ(message_of("0-30"), "id 30 is not in the family (--ids); its ids are 0-29");
  EXPECT_EQ(message_of("99999999999999999999"),
            "id 99999999999999999999 is not in the family (--ids); its ids are 0-29");
}

TEST(IdList, MalformedPartsAreNamed) {
  EXPECT_EQ(message_of("1,x"),
            "'x' in the id list '1,x' is not an id (--ids); write ids and ranges, like 0-9,12,20-");
  EXPECT_EQ(message_of("9-3"), "the id range '9-3' runs backwards (--ids); write 3-9");
  for (const char* text : {"", ",", "1,", "-", "-5", "1-2-3", "1.5", "+1", "0x1"}) {
    EXPECT_NE(message_of(text), "accepted") << text;
  }
}

}  // namespace
}  // namespace tagmint::cli
