#include "cluster/core_share.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

namespace tagmint::cluster {
namespace {

cpu_set_t cores(std::initializer_list<int> numbers) {
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const int core : numbers) CPU_SET(core, &set);
  return set;
}

TEST(CoreShare, OneProcessHasAllItsCores) {
  const cpu_set_t own = cores({0, 1, 5});
  EXPECT_EQ(share_of_cores(own, std::vector{own}), 3);
}

TEST(CoreShare, BoundProcessesHaveTheirOwnCores) {
  const std::vector all = {cores({0, 1}), cores({2, 3, 4})};
  EXPECT_EQ(share_of_cores(all[0], all), 2);
  EXPECT_EQ(share_of_cores(all[1], all), 3);
}

TEST(CoreShare, CommonCoresAreDivided) {
  const cpu_set_t own = cores({0, 1, 2, 3, 4, 5, 6});
  EXPECT_EQ(share_of_cores(own, std::vector{own, own}), 3);
  EXPECT_EQ(share_of_cores(own, std::vector{own, own, own, own, own, own, own}), 1);
}

TEST(CoreShare, NobodyIsWithoutAThread) {
  const cpu_set_t own = cores({0});
  EXPECT_EQ(share_of_cores(own, std::vector{own, own, own}), 1);
}

}  // namespace
}  // namespace tagmint::cluster
