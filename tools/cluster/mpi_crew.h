#pragma once

#include <boost/mpi/communicator.hpp>
#include <cstddef>
#include <memory>
#include <vector>

#include "cluster/mailbox.h"
#include "cluster/messages.h"
#include "cluster/round_division.h"
#include "tagmint/codec/search/crew.h"

namespace tagmint::cluster {

/// The crew that is all ranks of an MPI job, seen from the leader, rank 0. Its own threads work as
/// those of the others, while the main thread hands out chunks and gathers what comes back. Other
/// ranks must be in serve().
///   memory   as local_crew() on every rank; on the leader what a round keeps
class MpiCrew : public codec::SearchCrew {
 public:
  /// Tells the rules to all ranks.
  ///   threads       of each rank; 0 = each rank's share of its cores
  ///   own_threads   that share of the leader
  MpiCrew(const boost::mpi::communicator& ranks, const codec::SearchRules& rules, int threads,
          int own_threads);

  void learn(std::span<const codec::Codeword> codes) override;
  codec::SiftedWords sift(std::uint64_t first, std::uint64_t count) override;
  std::vector<codec::Codeword> list_open(std::uint64_t first, std::uint64_t count) override;

  /// Launchers kill a job one second after they have asked it to end, so that a round must be over
  /// in less.
  std::chrono::duration<double> round_length() const override {
    return std::chrono::milliseconds(500);
  }

 private:
  /// Works on a round, with all ranks where it pays. Returns the answers, ascending by chunk.
  std::vector<Answer> work(Task::Kind kind, std::uint64_t first, std::uint64_t count);
  std::vector<Answer> share(Task::Kind kind, RoundDivision& division);
  /// Sends the next chunk to `rank`; false when there is none.
  bool give(int rank, Task::Kind kind, RoundDivision& division);

  const boost::mpi::communicator& ranks_;
  LeaderMailbox mailbox_;
  std::unique_ptr<codec::SearchCrew> own_;
  std::vector<codec::Codeword> codes_;
  std::vector<std::size_t> codes_told_;  // of codes_, to each rank
  RankSpeeds sift_speeds_;
  RankSpeeds list_speeds_;
};

}  // namespace tagmint::cluster
