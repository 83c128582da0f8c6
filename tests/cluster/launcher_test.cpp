#include "cluster/launcher.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace tagmint::cluster {
namespace {

/// An environment without the variables of launchers; the tests may themselves run under one.
class Launcher : public testing::Test {
 protected:
  Launcher() {
    for (const char* name : {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMI_SIZE",
                             "PMIX_RANK", "SLURM_PROCID", "SLURM_NTASKS", "SLURM_STEP_NUM_TASKS"}) {
      unsetenv(name);
    }
  }
  static void set(const char* name, const char* value) { setenv(name, value, 1); }
};

TEST_F(Launcher, NoneWhereTheProgramWasStartedAlone) { EXPECT_FALSE(read_launch()); }

TEST_F(Launcher, AJobScriptOfSlurmIsNone) {
  set("SLURM_PROCID", "0");
  set("SLURM_NTASKS", "16");
  EXPECT_FALSE(read_launch());
}

TEST_F(Launcher, OpenMpiTellsRankAndRanks) {
  set("OMPI_COMM_WORLD_RANK", "2");
  set("OMPI_COMM_WORLD_SIZE", "4");
  set("PMIX_RANK", "2");
  const auto launch = read_launch();
  ASSERT_TRUE(launch);
  EXPECT_EQ(launch->rank, 2);
  EXPECT_EQ(launch->ranks, 4);
}

TEST_F(Launcher, SlurmTellsThemThroughPmix) {
  set("PMIX_RANK", "3");
  set("SLURM_STEP_NUM_TASKS", "8");
  const auto launch = read_launch();
  ASSERT_TRUE(launch);
  EXPECT_EQ(launch->rank, 3);
  EXPECT_EQ(launch->ranks, 8);
}

TEST_F(Launcher, PmiTellsThem) {
  set("PMI_RANK", "1");
  set("PMI_SIZE", "2");
  const auto launch = read_launch();
  ASSERT_TRUE(launch);
  EXPECT_EQ(launch->rank, 1);
  EXPECT_EQ(launch->ranks, 2);
}

TEST_F(Launcher, RanksMayBeUnknownAndWordsAreNoRanks) {
  set("PMIX_RANK", "x");
  EXPECT_FALSE(read_launch());
  set("PMIX_RANK", "5");
  ASSERT_TRUE(read_launch());
  EXPECT_EQ(read_launch()->ranks, 0);
}

}  // namespace
}  // namespace tagmint::cluster
