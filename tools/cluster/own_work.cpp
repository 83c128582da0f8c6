#include "cluster/own_work.h"

#include <utility>

#include "cluster/work.h"

namespace tagmint::cluster {

OwnWork::OwnWork(int rank, Task::Kind kind, RoundDivision& division, codec::SearchCrew& crew)
    : division_(division), crew_(crew), thread_([this, rank, kind] { run(rank, kind); }) {}

void OwnWork::run(int rank, Task::Kind kind) {
  try {
    while (const auto chunk = division_.take(rank)) {
      answers_.push_back(work_on(kind, *chunk, crew_));
      division_.done(rank, chunk->count, answers_.back().seconds);
    }
  } catch (...) {
    failure_ = std::current_exception();
    division_.cancel();
  }
  const std::scoped_lock lock(mutex_);
  done_ = true;
  changed_.notify_one();
}

bool OwnWork::wait(std::chrono::microseconds longest) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, longest, [this] { return done_; });
}

std::vector<Answer> OwnWork::answers() {
  if (failure_) std::rethrow_exception(failure_);
  return std::move(answers_);
}

}  // namespace tagmint::cluster
