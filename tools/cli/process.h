#pragma once

#include <stop_token>
#include <string_view>
#include <thread>

#include "tagmint/codec/errors.h"

namespace tagmint::cli {

/// The user ended the command (Ctrl-C, SIGTERM); exit code 130.
class Interrupted : public codec::Fault {
 public:
  using Fault::Fault;
};

/// Settings of the whole process, made once by main(): a closed stdin, stdout or stderr is kept
/// from being taken by the next opened file, a broken pipe becomes a write error, SIGINT and
/// SIGTERM end the program with exit code 130.
void prepare_process();

/// While it lives, the first SIGINT or SIGTERM asks for a stop instead of ending the program; the
/// second one ends it. One at a time. Throws std::logic_error when there is another one, and
/// std::system_error when no pipe or thread can be had.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  std::stop_token token() const { return source_.get_token(); }
  /// Throws Interrupted, naming what was left undone, when a stop was asked for.
  void throw_if_interrupted(std::string_view left_undone) const;

 private:
  std::stop_source source_;
  int pipe_[2] = {-1, -1};  // the signal handler writes to [1], the watcher reads from [0]
  std::thread watcher_;
};

}  // namespace tagmint::cli
