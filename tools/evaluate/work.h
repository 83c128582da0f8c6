#pragma once

#include <functional>
#include <stdexcept>
#include <stop_token>

namespace tagmint::evaluate {

/// Somebody asked for the end; what was finished is kept.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped") {}
};

/// The threads of a run, and who may end it.
class Work {
 public:
  /// `tick(done, total)` is called from the thread that calls for_each(), some times a second.
  using Tick = std::function<void(int done, int total)>;
  Work(int threads, std::stop_token stop, Tick tick);

  int threads() const { return threads_; }
  /// Throws Stopped when the end was asked for.
  void throw_if_stopped() const;

  /// Calls body(index, thread) for all 0 <= index < count, on threads 0 .. threads() - 1, in any
  /// order. Ends early and throws Stopped, or the first exception of a body.
  void for_each(int count, const std::function<void(int index, int thread)>& body) const;

 private:
  int threads_;
  std::stop_token stop_;
  Tick tick_;
};

}  // namespace tagmint::evaluate
