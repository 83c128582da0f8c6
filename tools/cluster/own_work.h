#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "cluster/messages.h"
#include "cluster/round_division.h"
#include "tagmint/codec/search/crew.h"

namespace tagmint::cluster {

/// The leader's part in a round: a thread that takes chunks and works on them until none is left,
/// beside the main thread, which is the one that may speak to other ranks.
class OwnWork {
 public:
  /// Starts. `division` and `crew` must outlive the object.
  OwnWork(int rank, Task::Kind kind, RoundDivision& division, codec::SearchCrew& crew);

  /// Waits until the work is done, but not for longer than that; whether it is done.
  bool wait(std::chrono::microseconds longest);
  /// What was done, when wait() has returned true. Throws what ended the work.
  std::vector<Answer> answers();

 private:
  void run(int rank, Task::Kind kind);

  RoundDivision& division_;
  codec::SearchCrew& crew_;
  std::vector<Answer> answers_;
  std::exception_ptr failure_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool done_ = false;
  std::jthread thread_;
};

}  // namespace tagmint::cluster
