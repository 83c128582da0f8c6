#include "cluster/own_work.h"

#include <gtest/gtest.h>

#include <new>
#include <optional>

namespace tagmint::cluster {
namespace {

/// Keeps every word; runs out of memory at word `fails_at`.
class EasyCrew : public codec::SearchCrew {
 public:
  explicit EasyCrew(std::optional<std::uint64_t> fails_at = std::nullopt) : fails_at_(fails_at) {}

  void learn(std::span<const codec::Codeword>) override {}
  codec::SiftedWords sift(std::uint64_t first, std::uint64_t count) override {
    codec::SiftedWords sifted;
    for (std::uint64_t i = first; i < first + count; ++i) {
      if (i == fails_at_) throw std::bad_alloc();
      sifted.kept.push_back({i, i});
    }
    return sifted;
  }
  std::vector<codec::Codeword> list_open(std::uint64_t first, std::uint64_t count) override {
    return std::vector<codec::Codeword>(count, first);
  }

 private:
  std::optional<std::uint64_t> fails_at_;
};

void wait_for(OwnWork& work) {
  while (!work.wait(std::chrono::milliseconds(1))) {
  }
}

TEST(OwnWork, TakesWhatOthersLeaveAndMeasuresItself) {
  RankSpeeds speeds(2);
  RoundDivision division(100, 50, speeds);
  EasyCrew crew;
  const auto taken_by_another = division.take(1);
  OwnWork work(0, Task::Kind::Sift, division, crew);
  wait_for(work);
  std::uint64_t next = taken_by_another->first + taken_by_another->count;
  for (const Answer& answer : work.answers()) {
    EXPECT_EQ(answer.chunk.first, next);
    EXPECT_EQ(answer.sifted.kept.size(), answer.chunk.count);
    next += answer.chunk.count;
  }
  EXPECT_EQ(next, 150U);
  EXPECT_GT(speeds.of(0), 0);
}

TEST(OwnWork, ListsWhereThatIsAsked) {
  RankSpeeds speeds(1);
  RoundDivision division(0, 3, speeds);
  EasyCrew crew;
  OwnWork work(0, Task::Kind::ListOpen, division, crew);
  wait_for(work);
  std::size_t words = 0;
  for (const Answer& answer : work.answers()) words += answer.open.size();
  EXPECT_EQ(words, 3U);
}

TEST(OwnWork, AFaultEndsTheRoundAndIsTold) {
  RankSpeeds speeds(1);
  RoundDivision division(0, 50, speeds);
  EasyCrew crew(7);
  OwnWork work(0, Task::Kind::Sift, division, crew);
  wait_for(work);
  EXPECT_THROW(work.answers(), std::bad_alloc);
  EXPECT_FALSE(division.take(0));
}

}  // namespace
}  // namespace tagmint::cluster
