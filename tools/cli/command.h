#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "tagmint/codec/errors.h"
#include "tagmint/codec/search/crew.h"

namespace CLI {
class App;
}

namespace tagmint::cli {

/// A wrong command line; exit code 2. Told as "WHAT (WHERE); HOW TO MEND" like every fault.
class UsageError : public codec::Fault {
 public:
  using Fault::Fault;
};

/// Exit codes of the program (docs: README, "Exit codes").
enum ExitCode : int {
  kDone = 0,
  kAnswerIsNo = 1,
  kUsage = 2,
  kBadInput = 3,
  kNoOutput = 4,
  kInterrupted = 130,
};

/// When progress bars are shown on stderr.
enum class ProgressMode { Auto, Always, Never, Json };

/// Options that every command takes.
struct Common {
  int threads = 0;  ///< 0 = all cores
  bool quiet = false;
  ProgressMode progress = ProgressMode::Auto;
  // No options, but how the program was started:
  codec::CrewMaker crew = {};  ///< who does the work of searches; nothing = this process
  int processes = 1;           ///< in the crew; without a crew, strangers
  int crew_cores = 0;          ///< that these have together, a thread each
};

/// Does the command's work after its options were parsed; returns the exit code, throws Fault for
/// faults.
using Runner = std::function<int()>;

/// One subcommand: its place in the command table and how it adds its options.
struct Command {
  std::string_view name;
  std::string_view summary;                  ///< one line, as `tagmint --help` lists it
  std::array<std::string_view, 2> examples;  ///< the end of `tagmint NAME --help`
  /// Adds options to `app`, and a description for the help where one line says too little; the
  /// returned function is called when this command was chosen. `common` outlives it.
  Runner (*set_up)(CLI::App& app, const Common& common);
};

}  // namespace tagmint::cli
