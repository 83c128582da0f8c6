#pragma once

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/request.hpp>
#include <list>
#include <optional>
#include <utility>

#include "cluster/messages.h"

namespace tagmint::cluster {

/// The leader's end of the line to the other ranks. Use from the main thread.
class LeaderMailbox {
 public:
  explicit LeaderMailbox(const boost::mpi::communicator& ranks) : ranks_(ranks) {}
  /// flush()
  ~LeaderMailbox();
  LeaderMailbox(const LeaderMailbox&) = delete;
  LeaderMailbox& operator=(const LeaderMailbox&) = delete;

  /// Sends a task on its way without waiting for the rank to take it.
  void post(int rank, const Task& task);
  /// An answer that has come, and from whom.
  std::optional<std::pair<int, Answer>> poll();
  /// Waits until all tasks posted have been taken.
  void flush();

 private:
  const boost::mpi::communicator& ranks_;
  std::list<boost::mpi::request> on_their_way_;
};

/// Waits for the next task of the leader without keeping a core busy.
Task receive_task(const boost::mpi::communicator& ranks);
void send_answer(const boost::mpi::communicator& ranks, const Answer& answer);

}  // namespace tagmint::cluster
