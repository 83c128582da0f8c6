#include "cluster/work.h"

#include <chrono>

namespace tagmint::cluster {

Answer work_on(Task::Kind kind, const Chunk& chunk, codec::SearchCrew& crew) {
  const auto start = std::chrono::steady_clock::now();
  Answer answer{.chunk = chunk, .seconds = 0, .sifted = {}, .open = {}};
  if (kind == Task::Kind::Sift) {
    answer.sifted = crew.sift(chunk.first, chunk.count);
  } else {
    answer.open = crew.list_open(chunk.first, chunk.count);
  }
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

}  // namespace tagmint::cluster
