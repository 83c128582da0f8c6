#include "cluster/round_division.h"

#include <algorithm>
#include <numeric>

namespace tagmint::cluster {

void RankSpeeds::learn(int rank, std::uint64_t pieces, double seconds) {
  constexpr double kShortest = 1e-6;  // of the clock
  constexpr double kWeight = 0.3;     // of the latest chunk; one in three may be an odd one
  const double speed = static_cast<double>(pieces) / std::max(seconds, kShortest);
  double& known = speeds_[rank];
  known = known == 0 ? speed : (1 - kWeight) * known + kWeight * speed;
}

double RankSpeeds::of(int rank) const {
  if (speeds_[rank] != 0) return speeds_[rank];
  const auto known = speeds_.size() - std::count(speeds_.begin(), speeds_.end(), 0.0);
  if (known == 0) return 0;
  return std::accumulate(speeds_.begin(), speeds_.end(), 0.0) / static_cast<double>(known);
}

double RankSpeeds::of_all() const {
  double sum = 0;
  for (int rank = 0; rank < static_cast<int>(speeds_.size()); ++rank) sum += of(rank);
  return sum;
}

RoundDivision::RoundDivision(std::uint64_t first, std::uint64_t count, RankSpeeds& speeds)
    : next_(first), left_(count), speeds_(speeds) {}

std::optional<Chunk> RoundDivision::take(int rank) {
  const std::scoped_lock lock(mutex_);
  if (left_ == 0) return std::nullopt;
  const Chunk chunk{next_, std::min(chunk_size(rank), left_)};
  next_ += chunk.count;
  left_ -= chunk.count;
  return chunk;
}

void RoundDivision::done(int rank, std::uint64_t pieces, double seconds) {
  const std::scoped_lock lock(mutex_);
  speeds_.learn(rank, pieces, seconds);
}

void RoundDivision::cancel() {
  const std::scoped_lock lock(mutex_);
  left_ = 0;
}

std::uint64_t RoundDivision::chunk_size(int rank) const {
  constexpr double kShortest_s = 0.002;  // some ten times what a message costs
  constexpr double kLongest_s = 0.040;
  constexpr double kShareOfRest = 0.25;  // two chunks wait for each rank: half of the rest is out
  const double speed = speeds_.of(rank);
  if (speed == 0) return 1;
  const double rest_s = static_cast<double>(left_) / speeds_.of_all();
  const double chunk_s = std::clamp(kShareOfRest * rest_s, kShortest_s, kLongest_s);
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(speed * chunk_s));
}

}  // namespace tagmint::cluster
