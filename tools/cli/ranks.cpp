#include "cli/ranks.h"

#include <fmt/format.h>

#include <csignal>
#include <optional>
#include <string>

#include "cli/command.h"
#include "cli/faults.h"
#include "cli/program.h"
#include "cli/terminal.h"
#include "cluster/cluster.h"

namespace tagmint::cli {
namespace {

std::string joined(int argc, const char* const* argv) {
  std::string text;
  for (int i = 1; i < argc; ++i) (text += argv[i]) += '\0';
  return text;
}

/// Launchers send the signals of a user to all processes; the leader ends the program in order, and
/// the others have to be there for that.
void leave_signals_to_the_leader() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_IGN);
}

int lead(cluster::Cluster& cluster, int argc, const char* const* argv) {
  Common common;
  common.crew = cluster.crew_maker();
  common.processes = cluster.ranks();
  common.crew_cores = cluster.cores();
  const int exit_code = run_program(argc, argv, common);
  cluster.end(exit_code);
  return exit_code;
}

/// A fault of one rank is the end of all.
int serve(cluster::Cluster& cluster) {
  try {
    return cluster.serve();
  } catch (const std::exception& error) {
    print_error(fmt::format("{}: {}; all processes are ended", cluster.name(), error.what()));
    cluster.abort(kNoOutput);
  }
}

}  // namespace

int run_program_on_ranks(const cluster::Launch& launch, int argc, const char* const* argv) {
  std::optional<cluster::Cluster> cluster;
  const int joined_in = report_faults([&] {
    cluster.emplace();
    return kDone;
  });
  if (joined_in != kDone) return joined_in;
  if (launch.ranks > 0 && launch.ranks != cluster->ranks()) {
    return run_program(argc, argv, strangers(launch));
  }
  if (!cluster->same_everywhere(joined(argc, argv))) return run_program(argc, argv);
  if (cluster->leads()) return lead(*cluster, argc, argv);
  leave_signals_to_the_leader();
  return serve(*cluster);
}

}  // namespace tagmint::cli
