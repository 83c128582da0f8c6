#include "detector/contender.h"

namespace tagmint::bench {

#ifndef TAGMINT_HAVE_APRILTAG
std::vector<ContenderKind> libapriltag_contenders() { return {}; }
#endif
#ifndef TAGMINT_HAVE_OPENCV
std::vector<ContenderKind> opencv_contenders() { return {}; }
#endif

std::vector<ContenderKind> all_contenders() {
  std::vector<ContenderKind> kinds = tagmint_contenders();
  for (const auto& peers : {libapriltag_contenders(), opencv_contenders()}) {
    kinds.insert(kinds.end(), peers.begin(), peers.end());
  }
  return kinds;
}

}  // namespace tagmint::bench
