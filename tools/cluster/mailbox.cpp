#include "cluster/mailbox.h"

#include <algorithm>
#include <boost/mpi/exception.hpp>
#include <chrono>
#include <thread>

#include "cluster/message_archive.h"

namespace tagmint::cluster {
namespace {

constexpr int kLeader = 0;
constexpr int kTaskTag = 1;
constexpr int kAnswerTag = 2;

}  // namespace

LeaderMailbox::~LeaderMailbox() {
  try {
    flush();
  } catch (const boost::mpi::exception&) {
    // The line is broken, and whoever posts or polls next is told so.
  }
}

void LeaderMailbox::post(int rank, const Task& task) {
  on_their_way_.remove_if([](boost::mpi::request& request) { return request.test().has_value(); });
  on_their_way_.push_back(ranks_.isend(rank, kTaskTag, task));
}

std::optional<std::pair<int, Answer>> LeaderMailbox::poll() {
  const auto waiting = ranks_.iprobe(boost::mpi::any_source, kAnswerTag);
  if (!waiting) return std::nullopt;
  std::pair<int, Answer> mail{waiting->source(), {}};
  ranks_.recv(mail.first, kAnswerTag, mail.second);
  return mail;
}

void LeaderMailbox::flush() {
  for (boost::mpi::request& request : on_their_way_) request.wait();
  on_their_way_.clear();
}

Task receive_task(const boost::mpi::communicator& ranks) {
  // MPI's own waiting spins. Between two tasks of a round the next one is there already; a pause
  // that lasts may be slept through.
  constexpr std::chrono::microseconds kShortestNap{50};
  constexpr std::chrono::microseconds kLongestNap{1000};
  std::chrono::microseconds nap = kShortestNap;
  while (!ranks.iprobe(kLeader, kTaskTag)) {
    std::this_thread::sleep_for(nap);
    nap = std::min(2 * nap, kLongestNap);
  }
  Task task;
  ranks.recv(kLeader, kTaskTag, task);
  return task;
}

void send_answer(const boost::mpi::communicator& ranks, const Answer& answer) {
  ranks.send(kLeader, kAnswerTag, answer);
}

}  // namespace tagmint::cluster
