#pragma once

#include <memory>
#include <string>

#include "tagmint/codec/search/crew.h"

namespace tagmint::cluster {

/// This process's place among the processes of an MPI job, its *ranks*. Rank 0 leads: it runs the
/// program, the others work for its searches. One object a process, in the main thread, which alone
/// calls MPI.
class Cluster {
 public:
  /// Joins the job; alone where MPI and the launcher do not understand each other.
  Cluster();
  /// Waits for the other ranks and leaves.
  ~Cluster();
  Cluster(const Cluster&) = delete;
  Cluster& operator=(const Cluster&) = delete;

  int rank() const;
  int ranks() const;
  /// Cores of all ranks together, each counted once where several may run on it.
  int cores() const;
  bool leads() const { return rank() == 0; }
  /// "rank 3 on node17", for messages.
  std::string name() const;

  /// Whether all ranks came with the same text. All ranks must call it.
  bool same_everywhere(const std::string& text) const;

  /// For the leader: makes crews of all ranks, one at a time. The object must outlive them.
  codec::CrewMaker crew_maker();
  /// For the leader: the program is over, and this is its exit code.
  void end(int exit_code);

  /// For the others: works until the leader's end(); returns its exit code.
  int serve();

  /// Ends all ranks at once, with this exit code.
  [[noreturn]] void abort(int exit_code);

 private:
  struct Job;
  std::unique_ptr<Job> job_;
};

}  // namespace tagmint::cluster
