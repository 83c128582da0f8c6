#include "cli/progress.h"

#include <gtest/gtest.h>

namespace tagmint::cli {
namespace {

ProgressState half_done() {
  return {.task = "search",
          .unit = "words",
          .done = 5e6,
          .total = 1e7,
          .elapsed_s = 100,
          .note = "38 codes"};
}

TEST(Progress, BarShowsShareRateNoteAndTimeLeft) {
  EXPECT_EQ(progress_bar(half_done(), 80),
            "search [##########..........]  50 %  50k words/s  38 codes  ETA 1:40");
}

TEST(Progress, BarFitsTheTerminal) { EXPECT_EQ(progress_bar(half_done(), 10), "search [##"); }

TEST(Progress, UnknownTotalHasNeitherBarNorTimeLeft) {
  ProgressState state = half_done();
  state.total = 0;
  EXPECT_EQ(progress_bar(state, 80), "search  50k words/s  38 codes");
  EXPECT_EQ(progress_json(state),
            R"({"task":"search","unit":"words","done":5000000.0,"total":null,"elapsed_s":100.0,)"
            R"("rate":50000.0,"eta_s":null,"note":"38 codes"})");
}

TEST(Progress, LongTimesAreWrittenInHoursDaysAndYears) {
  ProgressState state = half_done();
  state.elapsed_s = 2 * 3600 + 3 * 60 + 4;
  EXPECT_NE(progress_bar(state, 80).find("ETA 2:03:04"), std::string::npos);
  state.elapsed_s = 5 * 86400;
  EXPECT_NE(progress_bar(state, 80).find("ETA 5 days"), std::string::npos);
  state.elapsed_s = 1e12;
  EXPECT_NE(progress_bar(state, 80).find("ETA years"), std::string::npos);
}

TEST(Progress, MoreThanTheTotalIsFull) {
  ProgressState state = half_done();
  state.done = 2e7;
  EXPECT_NE(progress_bar(state, 80).find("[####################] 100 %"), std::string::npos);
}

}  // namespace
}  // namespace tagmint::cli
