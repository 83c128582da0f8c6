#include "cluster/mpi_crew.h"

#include <algorithm>
#include <iterator>
#include <thread>
#include <utility>

#include "cluster/own_work.h"
#include "cluster/work.h"

namespace tagmint::cluster {
namespace {

constexpr int kLeader = 0;

}  // namespace

MpiCrew::MpiCrew(const boost::mpi::communicator& ranks, const codec::SearchRules& rules,
                 int threads, int own_threads)
    : ranks_(ranks),
      mailbox_(ranks),
      own_(codec::local_crew(rules, threads > 0 ? threads : own_threads)),
      codes_told_(ranks.size(), 0),
      sift_speeds_(ranks.size()),
      list_speeds_(ranks.size()) {
  const Task begin{.kind = Task::Kind::Begin,
                   .rules = rules_text(rules),
                   .number = threads,
                   .chunk = {},
                   .new_codes = {}};
  for (int rank = kLeader + 1; rank < ranks_.size(); ++rank) mailbox_.post(rank, begin);
}

void MpiCrew::learn(std::span<const codec::Codeword> codes) {
  own_->learn(codes);
  codes_.insert(codes_.end(), codes.begin(), codes.end());
}

codec::SiftedWords MpiCrew::sift(std::uint64_t first, std::uint64_t count) {
  codec::SiftedWords all;
  for (const Answer& answer : work(Task::Kind::Sift, first, count)) {
    const std::vector<codec::KeptWord>& kept = answer.sifted.kept;
    all.kept.insert(all.kept.end(), kept.begin(), kept.end());
    all.distant += answer.sifted.distant;
  }
  return all;
}

std::vector<codec::Codeword> MpiCrew::list_open(std::uint64_t first, std::uint64_t count) {
  std::vector<codec::Codeword> all;
  for (const Answer& answer : work(Task::Kind::ListOpen, first, count)) {
    all.insert(all.end(), answer.open.begin(), answer.open.end());
  }
  return all;
}

std::vector<Answer> MpiCrew::work(Task::Kind kind, std::uint64_t first, std::uint64_t count) {
  constexpr double kWorthSharing_s = 0.020;  // against a millisecond until all have a chunk
  RankSpeeds& speeds = kind == Task::Kind::Sift ? sift_speeds_ : list_speeds_;
  if (static_cast<double>(count) <= kWorthSharing_s * speeds.of(kLeader) || !speeds.of(kLeader)) {
    std::vector<Answer> answers = {work_on(kind, {first, count}, *own_)};
    speeds.learn(kLeader, count, answers.front().seconds);
    return answers;
  }
  RoundDivision division(first, count, speeds);
  std::vector<Answer> answers = share(kind, division);
  std::sort(answers.begin(), answers.end(),
            [](const Answer& a, const Answer& b) { return a.chunk.first < b.chunk.first; });
  return answers;
}

std::vector<Answer> MpiCrew::share(Task::Kind kind, RoundDivision& division) {
  constexpr int kChunksAhead = 2;  // one to work on while the answer to the other travels
  constexpr std::chrono::microseconds kNap{500};
  std::vector<Answer> answers;
  int awaited = 0;
  for (int i = 0; i < kChunksAhead; ++i) {
    for (int rank = kLeader + 1; rank < ranks_.size(); ++rank) {
      awaited += give(rank, kind, division) ? 1 : 0;
    }
  }
  OwnWork own(kLeader, kind, division, *own_);
  bool own_done = false;
  while (awaited > 0 || !own_done) {
    if (auto mail = mailbox_.poll()) {
      auto& [rank, answer] = *mail;
      division.done(rank, answer.chunk.count, answer.seconds);
      if (!give(rank, kind, division)) --awaited;
      answers.push_back(std::move(answer));
    } else if (own_done) {
      std::this_thread::sleep_for(kNap);
    } else {
      own_done = own.wait(kNap);
    }
  }
  std::vector<Answer> ours = own.answers();
  std::move(ours.begin(), ours.end(), std::back_inserter(answers));
  return answers;
}

bool MpiCrew::give(int rank, Task::Kind kind, RoundDivision& division) {
  const std::optional<Chunk> chunk = division.take(rank);
  if (!chunk) return false;
  Task task{.kind = kind, .rules = {}, .number = 0, .chunk = *chunk, .new_codes = {}};
  task.new_codes.assign(codes_.begin() + static_cast<std::ptrdiff_t>(codes_told_[rank]),
                        codes_.end());
  codes_told_[rank] = codes_.size();
  mailbox_.post(rank, task);
  return true;
}

}  // namespace tagmint::cluster
