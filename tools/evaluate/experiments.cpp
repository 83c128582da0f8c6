#include <array>

#include "evaluate/experiment.h"
#include "evaluate/experiments/kinds.h"

namespace tagmint::evaluate {

std::span<const ExperimentKind> experiment_kinds() {
  static const std::array kinds = {distance_kind(), angle_kind(), range_kind(),
                                   mosaic_kind(), robustness_kind()};
  return kinds;
}

}  // namespace tagmint::evaluate
