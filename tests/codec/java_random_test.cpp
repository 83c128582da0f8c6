#include "search/java_random.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace tagmint::codec {
namespace {

struct Observed {
  std::int64_t seed;
  std::int32_t ints[2];   // the first two nextInt()
  std::int64_t longs[2];  // the first two nextLong() of a fresh generator
};

// Printed by OpenJDK's java.util.Random.
constexpr Observed kObserved[] = {
    {0, {-1155484576, -723955400}, {-4962768465676381896, 4437113781045784766}},
    {1, {-1155869325, 431529176}, {-4964420948893066024, 7564655870752979346}},
    {42, {-1170105035, 234785527}, {-5025562857975149833, -5843495416241995736}},
    {-1, {1155099827, 1887904451}, {4961115982468162243, 226341162490527646}},
    {361110, {644307837, -398165510}, {2767281088073333242, 7146334579375990241}},
    {411210, {1622617021, 1339402059}, {6969087040467347275, -2447249733502633349}},
    {std::numeric_limits<std::int64_t>::max(),
     {1155099827, 1887904451},
     {4961115982468162243, 226341162490527646}},
    {std::numeric_limits<std::int64_t>::min(),
     {-1155484576, -723955400},
     {-4962768465676381896, 4437113781045784766}},
    {25214903917, {0, 4232237}, {4232237, 767956431209526212}},
};

TEST(JavaRandom, GivesTheNumbersOfJava) {
  for (const Observed& observed : kObserved) {
    JavaRandom ints(observed.seed);
    JavaRandom longs(observed.seed);
    for (const std::int32_t expected : observed.ints) EXPECT_EQ(ints.next_int(), expected);
    for (const std::int64_t expected : observed.longs) EXPECT_EQ(longs.next_long(), expected);
  }
}

}  // namespace
}  // namespace tagmint::codec
