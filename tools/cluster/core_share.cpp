#include "cluster/core_share.h"

#include <algorithm>

namespace tagmint::cluster {

int share_of_cores(const cpu_set_t& own, std::span<const cpu_set_t> all) {
  constexpr double kRounding = 1e-6;
  double share = 0;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (!CPU_ISSET(core, &own)) continue;
    const auto users = std::count_if(all.begin(), all.end(), [core](const cpu_set_t& cores) {
      return CPU_ISSET(core, &cores) != 0;
    });
    share += 1.0 / static_cast<double>(std::max<std::ptrdiff_t>(users, 1));
  }
  return std::max(1, static_cast<int>(share + kRounding));
}

}  // namespace tagmint::cluster
