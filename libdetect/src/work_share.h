#pragma once

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace tagmint::detect {

/// Shares the independent parts of one frame's work between threads.
class WorkShare {
 public:
  /// `threads`: those asked for, 0 = all; no more than there are cores are used.
  explicit WorkShare(int threads);

  int threads() const { return threads_; }

  /// Calls function(i, worker) for all i in [0, size). Each i writes to its own place, so the order
  /// does not matter.
  ///   workers   one for each thread that takes part, made as needed:
  ///   tbb::enumerable_thread_specific
  template <typename Workers, typename Function>
  void for_each_index(std::size_t size, Workers& workers, const Function& function) {
    if (threads_ == 1) {
      auto& worker = workers.local();
      for (std::size_t i = 0; i < size; ++i) function(i, worker);
      return;
    }
    arena_.execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, size), [&](const auto& range) {
        auto& worker = workers.local();
        for (std::size_t i = range.begin(); i != range.end(); ++i) function(i, worker);
      });
    });
  }

 private:
  int threads_;
  tbb::task_arena arena_;
};

/// Adds what each worker counted in its `stats` to `total`, and sets it back to nothing.
template <typename Workers, typename Stats>
void collect_stats(Workers& workers, Stats& total) {
  for (auto& worker : workers) {
    total += worker.stats;
    worker.stats = {};
  }
}

}  // namespace tagmint::detect
