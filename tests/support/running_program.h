#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace tagmint::test {

/// How a program ended.
struct ProgramResult {
  int exit_code = 0;  ///< 128 + signal number when a signal ended it
  std::string out;    ///< all of its stdout
  std::string err;    ///< all of its stderr
};

/// Where a program's stderr goes.
enum class Stderr { Pipe, Terminal };

/// A program that runs beside the test; its stdin is empty.
class RunningProgram {
 public:
  /// Starts `words[0]` (a path) with the other words as its arguments. `environment` adds
  /// "NAME=VALUE" entries. Throws std::runtime_error when it cannot be started.
  explicit RunningProgram(const std::vector<std::string>& words, Stderr stderr_kind = Stderr::Pipe,
                          const std::vector<std::string>& environment = {});
  /// Kills the program if it still runs.
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Reads until stderr holds `text`; false when the program ended without it.
  bool wait_for_stderr(const std::string& text);
  void send_signal(int signal);
  /// Waits for the end of the program.
  ProgramResult finish();

 private:
  bool read_some();

  pid_t pid_ = -1;
  int out_ = -1;
  int err_ = -1;
  ProgramResult result_;
};

/// Runs a program from start to end.
ProgramResult run(const std::vector<std::string>& words);

}  // namespace tagmint::test
