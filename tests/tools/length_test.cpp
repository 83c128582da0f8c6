#include "cli/length.h"

#include <gtest/gtest.h>

#include <string>

#include "cli/command.h"

namespace tagmint::cli {
namespace {

std::string message_of(std::string_view text) {
  try {
    parse_length_mm(text, "--edge");
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Length, UnitsAreTurnedIntoMillimetres) {
  EXPECT_DOUBLE_EQ(parse_length_mm("40mm"), 40.0);
  EXPECT_DOUBLE_EQ(parse_length_mm("4cm"), 40.0);
  EXPECT_DOUBLE_EQ(parse_length_mm("0.04m"), 40.0);
  EXPECT_DOUBLE_EQ(parse_length_mm("1.5in"), 38.1);
  EXPECT_DOUBLE_EQ(parse_length_mm("72pt"), 25.4);
}

TEST(Length, SpacesAroundAndZeroAreFine) {
  EXPECT_DOUBLE_EQ(parse_length_mm(" 40 mm "), 40.0);
  EXPECT_DOUBLE_EQ(parse_length_mm("0mm"), 0.0);
  EXPECT_DOUBLE_EQ(parse_length_mm("1e2mm"), 100.0);
}

TEST(Length, BareNumberIsToldToTakeAUnit) {
  EXPECT_EQ(message_of("40"),
            "the length '40' has no unit (--edge); add one of mm, cm, m, in, pt, like 40mm");
}

TEST(Length, BeyondAKilometreIsAMistypedExponent) {
  EXPECT_DOUBLE_EQ(parse_length_mm("1000m"), 1e6);
  EXPECT_EQ(message_of("1e300mm"),
            "the length '1e300mm' is above 1000 m (--edge); write a shorter one, like 40mm");
}

TEST(Length, FaultsNameTheTextAndTheOption) {
  EXPECT_EQ(message_of("mm"),
            "'mm' is not a length (--edge); write a number and a unit (mm, cm, m, in, pt), like "
            "40mm");
  EXPECT_EQ(message_of("40mmm"),
            "the length '40mmm' has the unknown unit 'mmm' (--edge); use one of mm, cm, m, in, pt");
  EXPECT_EQ(message_of("-4mm"),
            "the length '-4mm' is negative (--edge); write a length of zero or more, like 40mm");
  for (const char* text : {"", "inf", "nanmm", "1e999mm", "infmm", "4,5mm", "0x4mm"}) {
    EXPECT_NE(message_of(text), "accepted") << text;
  }
}

}  // namespace
}  // namespace tagmint::cli
