#include "evaluate/work.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace tagmint::evaluate {

Work::Work(int threads, std::stop_token stop, Tick tick)
    : threads_(threads > 0 ? threads
                           : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))),
      stop_(std::move(stop)),
      tick_(std::move(tick)) {}

void Work::throw_if_stopped() const {
  if (stop_.stop_requested()) throw Stopped();
}

void Work::for_each(int count, const std::function<void(int, int)>& body) const {
  std::atomic<int> next = 0;
  std::mutex mutex;
  std::condition_variable changed;
  int done = 0;
  int running = std::min(threads_, count);
  std::exception_ptr fault;

  const auto run = [&](int thread) {
    try {
      for (int i = next++; i < count && !stop_.stop_requested(); i = next++) {
        body(i, thread);
        const std::lock_guard lock(mutex);
        ++done;
      }
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!fault) fault = std::current_exception();
    }
    const std::lock_guard lock(mutex);
    --running;
    changed.notify_one();
  };

  std::vector<std::jthread> crew;
  const int members = running;
  for (int thread = 0; thread < members; ++thread) crew.emplace_back(run, thread);
  std::unique_lock lock(mutex);
  while (!changed.wait_for(lock, std::chrono::milliseconds(100), [&] { return running == 0; })) {
    const int so_far = done;
    lock.unlock();
    if (tick_) tick_(so_far, count);
    lock.lock();
  }
  lock.unlock();
  crew.clear();
  if (fault) std::rethrow_exception(fault);
  throw_if_stopped();
}

}  // namespace tagmint::evaluate
