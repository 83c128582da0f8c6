#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "search/parallel.h"
#include "tagmint/codec/family.h"

namespace tagmint::codec {

/// Calls work(worker, first id, codewords) for stretches of a family's codewords that together are
/// all of them. `workers` threads share them; a worker's stretches come in the order of their ids.
template <typename Work>
void for_each_stretch(const Family& family, int workers, const Work& work) {
  constexpr std::size_t kCodewordsAtATime = 1024;
  std::atomic<std::size_t> next{0};
  run_workers(workers, [&](int worker) {
    for (std::size_t id; (id = next.fetch_add(kCodewordsAtATime)) < family.size();) {
      const auto first = static_cast<TagId>(id);
      work(worker, first, some_codewords(family, first, kCodewordsAtATime));
    }
  });
}

}  // namespace tagmint::codec
