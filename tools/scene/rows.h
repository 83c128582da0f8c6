#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace tagmint::scene {

/// Calls work(y) for each row, on the threads of the task arena that it is called in.
template <typename Work>
void for_each_row(int height, Work work) {
  constexpr int kRowsAtOnce = 16;
  tbb::parallel_for(tbb::blocked_range<int>(0, height, kRowsAtOnce), [&](const auto& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y) work(y);
  });
}

}  // namespace tagmint::scene
