#include "tagmint/codec/search/rotation_codes.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include "tagmint/codec/family_check.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::codec {
namespace {

RotationCodeOptions options_for(const std::string& layout, int min_hamming,
                                const std::vector<int>& levels) {
  return {.layout = parse_layout(layout),
          .min_hamming = min_hamming,
          .levels = levels,
          .complexity = {ComplexityRule::Energy, 0.3333}};
}

TEST(RotationCodes, SixtyTagsOfSixteenBitsWhateverTheThreads) {
  RotationCodeOptions options = options_for("classic:8", 5, {8});
  options.threads = 1;
  const Family one = make_family(search_rotation_code(options));
  options.threads = 2;
  const Family two = make_family(search_rotation_code(options));
  EXPECT_EQ(one.name(), "rot16h5");
  EXPECT_EQ(one.size(), 60u);
  EXPECT_EQ(one.levels().front().min_hamming, 8);
  EXPECT_TRUE(one.is_listed());
  EXPECT_EQ(one.origin().method, "rotation-code");
  EXPECT_EQ(first_codewords(one, 60), first_codewords(two, 60));
  const FamilyCheck check = check_family(one);
  EXPECT_FALSE(check.violation) << check.violation->message;
}

TEST(RotationCodes, LevelsOfThirtySixBitsAreProvenAndStoredAsAGenerator) {
  const Family family =
      make_family(search_rotation_code(options_for("classic:10", 12, {16})), "mine");
  EXPECT_EQ(family.name(), "mine");
  EXPECT_FALSE(family.is_listed());
  ASSERT_EQ(family.levels().size(), 2u);
  EXPECT_GE(family.levels()[0].min_hamming, 16);
  EXPECT_GE(family.size(), 2016u);
  const FamilyCheck check = check_family(family);
  EXPECT_FALSE(check.violation) << check.violation->message;
}

TEST(RotationCodes, SixteenThousandTagsOfThirtySixBitsAtDistanceTen) {
  const RotationCodeResult result = search_rotation_code(options_for("classic:10", 10, {14, 12}));
  EXPECT_EQ(result.construction, "lifted quasi-cyclic code");
  const Family family = make_family(result);
  ASSERT_EQ(family.levels().size(), 3u);
  EXPECT_EQ(family.levels()[0].codes, 120u);
  EXPECT_EQ(family.levels()[1].codes, 240u);
  EXPECT_EQ(family.size(), 16320u);
  const FamilyCheck check = check_family(family);
  EXPECT_FALSE(check.violation) << check.violation->message;
}

TEST(RotationCodes, StoppedSearchHasNoFamily) {
  std::stop_source stop;
  stop.request_stop();
  RotationCodeOptions options = options_for("classic:10", 8, {});
  options.stop = stop.get_token();
  const RotationCodeResult result = search_rotation_code(options);
  EXPECT_TRUE(result.stopped);
  EXPECT_FALSE(result.found());
}

TEST(RotationCodes, ImpossibleOptionsAreNamed) {
  EXPECT_THROW(search_rotation_code(options_for("classic:8", 0, {})), std::invalid_argument);
  EXPECT_THROW(search_rotation_code(options_for("classic:8", 17, {})), std::invalid_argument);
  EXPECT_THROW(search_rotation_code(options_for("classic:8", 5, {5})), std::invalid_argument);
  EXPECT_THROW(search_rotation_code(options_for("classic:8", 5, {17})), std::invalid_argument);
  RotationCodeOptions options = options_for("classic:8", 5, {});
  options.attempts = 0;
  EXPECT_THROW(search_rotation_code(options), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::codec
