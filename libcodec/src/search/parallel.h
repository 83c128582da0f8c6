#pragma once

#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tagmint::codec {

/// `threads`, or the number of cores where it is 0 or less.
inline int thread_count(int threads) {
  if (threads > 0) return threads;
  const unsigned cores = std::thread::hardware_concurrency();
  return cores > 0 ? static_cast<int>(cores) : 1;
}

/// Runs work(0) .. work(workers - 1), each in a thread of its own, worker 0 in the calling one, and
/// waits for all. The first exception that a worker ends with is thrown again here.
template <typename Work>
void run_workers(int workers, const Work& work) {
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto guarded = [&](int worker) {
    try {
      work(worker);
    } catch (...) {
      const std::scoped_lock lock(failure_mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    others.reserve(workers > 1 ? workers - 1 : 0);
    for (int worker = 1; worker < workers; ++worker) others.emplace_back(guarded, worker);
    guarded(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace tagmint::codec
