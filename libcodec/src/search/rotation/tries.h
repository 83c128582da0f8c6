#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "search/parallel.h"

namespace tagmint::codec {

/// Makes `count` tries, make(0) .. make(count - 1), in several threads, and returns all results in
/// that order: they do not depend on the threads. Nothing where it was asked to stop.
///   told   called after each try of the calling thread with the number of tries done
template <typename Result>
std::optional<std::vector<Result>> make_tries(std::size_t count, int threads,
                                              const std::stop_token& stop,
                                              const std::function<Result(std::size_t)>& make,
                                              const std::function<void(std::size_t)>& told) {
  std::vector<std::optional<Result>> results(count);
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
  const int workers = static_cast<int>(
      std::min<std::size_t>(static_cast<std::size_t>(thread_count(threads)), count));
  run_workers(workers, [&](int worker) {
    for (std::size_t i; !stop.stop_requested() && (i = next.fetch_add(1)) < count;) {
      results[i] = make(i);
      ++done;
      if (worker == 0) told(done);
    }
  });
  if (stop.stop_requested()) return std::nullopt;
  std::vector<Result> all;
  for (std::optional<Result>& result : results) all.push_back(std::move(*result));
  return all;
}

}  // namespace tagmint::codec
