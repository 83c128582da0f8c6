#include "cluster/cluster.h"

#include <fmt/format.h>
#include <sched.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/environment.hpp>
#include <cstdlib>
#include <functional>
#include <vector>

#include "cluster/core_share.h"
#include "cluster/mailbox.h"
#include "cluster/mpi_crew.h"
#include "cluster/serve.h"

namespace tagmint::cluster {
namespace {

namespace mpi = boost::mpi;

/// The part of this machine's cores that is this rank's.
int own_share_of_cores(const mpi::communicator& ranks) {
  cpu_set_t own;
  CPU_ZERO(&own);
  // Where it fails, as with more cores than the set has room for, the rank still takes part below.
  const bool known = sched_getaffinity(0, sizeof own, &own) == 0;
  MPI_Comm handle = MPI_COMM_NULL;
  MPI_Comm_split_type(ranks, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &handle);
  const mpi::communicator machine(handle, mpi::comm_take_ownership);
  std::vector<cpu_set_t> all(machine.size());
  MPI_Allgather(&own, sizeof own, MPI_BYTE, all.data(), sizeof own, MPI_BYTE, machine);
  return known ? share_of_cores(own, all) : 1;
}

}  // namespace

struct Cluster::Job {
  // Only the main thread calls MPI; faults come as exceptions.
  Job() : environment(mpi::threading::funneled, /*abort_on_exception=*/false) {}

  mpi::environment environment;
  mpi::communicator world;
  int threads = own_share_of_cores(world);
  int all_threads = mpi::all_reduce(world, threads, std::plus<int>());
};

Cluster::Cluster() : job_(std::make_unique<Job>()) {}

Cluster::~Cluster() = default;

int Cluster::rank() const { return job_->world.rank(); }

int Cluster::ranks() const { return job_->world.size(); }

int Cluster::cores() const { return job_->all_threads; }

std::string Cluster::name() const {
  return fmt::format("rank {} on {}", rank(), mpi::environment::processor_name());
}

bool Cluster::same_everywhere(const std::string& text) const {
  const std::size_t own = std::hash<std::string>{}(text);
  std::size_t leaders = own;
  mpi::broadcast(job_->world, leaders, 0);
  return mpi::all_reduce(job_->world, own == leaders ? 1 : 0, std::multiplies<int>()) == 1;
}

codec::CrewMaker Cluster::crew_maker() {
  return [job = job_.get()](const codec::SearchRules& rules, int threads) {
    return std::make_unique<MpiCrew>(job->world, rules, threads, job->threads);
  };
}

void Cluster::end(int exit_code) {
  LeaderMailbox mailbox(job_->world);
  const Task end{
      .kind = Task::Kind::End, .rules = {}, .number = exit_code, .chunk = {}, .new_codes = {}};
  for (int rank = 1; rank < ranks(); ++rank) mailbox.post(rank, end);
  mailbox.flush();
}

int Cluster::serve() { return cluster::serve(job_->world, job_->threads); }

void Cluster::abort(int exit_code) {
  mpi::environment::abort(exit_code);
  std::abort();
}

}  // namespace tagmint::cluster
