#include "work_share.h"

#include <tbb/info.h>

#include <algorithm>

namespace tagmint::detect {
namespace {

/// Above the number of cores oneTBB would complain on the error stream.
int shared_by(int asked) {
  const int cores = tbb::info::default_concurrency();
  return asked == 0 ? cores : std::min(asked, cores);
}

}  // namespace

WorkShare::WorkShare(int threads) : threads_(shared_by(threads)), arena_(threads_) {}

}  // namespace tagmint::detect
