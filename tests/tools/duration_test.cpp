#include "cli/duration.h"

#include <gtest/gtest.h>

#include <string>

#include "cli/command.h"

namespace tagmint::cli {
namespace {

std::string message_of(std::string_view text) {
  try {
    parse_duration(text, "--time-limit");
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Duration, UnitsAreTurnedIntoSecondsAndAdded) {
  EXPECT_DOUBLE_EQ(parse_duration("90s").count(), 90.0);
  EXPECT_DOUBLE_EQ(parse_duration("0.5s").count(), 0.5);
  EXPECT_DOUBLE_EQ(parse_duration("5min").count(), 300.0);
  EXPECT_DOUBLE_EQ(parse_duration("5m").count(), 300.0);
  EXPECT_DOUBLE_EQ(parse_duration("1.5h").count(), 5400.0);
  EXPECT_DOUBLE_EQ(parse_duration("2d").count(), 172800.0);
  EXPECT_DOUBLE_EQ(parse_duration("1h30min").count(), 5400.0);
}

TEST(Duration, FaultsNameTheTextAndTheOption) {
  EXPECT_EQ(message_of("90"),
            "the time '90' has no unit (--time-limit); write numbers with s, min, h or d, like 90s "
            "or 1h30min");
  EXPECT_EQ(message_of("5w"),
            "the time '5w' has the unknown unit 'w' (--time-limit); write numbers with s, min, h "
            "or d, like 90s or 1h30min");
  for (const char* text : {"", "s", "0s", "-1s", "1h30", "1hs", "soon"}) {
    EXPECT_NE(message_of(text), "accepted") << text;
  }
}

}  // namespace
}  // namespace tagmint::cli
