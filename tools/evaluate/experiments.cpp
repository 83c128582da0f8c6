#include <array>

#include "evaluate/experiment.h"
#include "evaluate/experiments/kinds.h"

namespace tagmint::evaluate {

std::span<const ExperimentKind> experiment_kinds() {
  // One line an experiment, and its file in experiments/.
  // clang-format off
  static const std::array kinds = {
      distance_kind(),
      angle_kind(),
      range_kind(),
      mosaic_kind(),
      false_positives_kind(),
      timing_kind(),
      families_kind(),
      robustness_kind(),
      codec_kind(),
  };
  // clang-format on
  return kinds;
}

}  // namespace tagmint::evaluate
