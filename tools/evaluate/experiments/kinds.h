#pragma once

#include "evaluate/experiment.h"

namespace tagmint::evaluate {

// One function an experiment, each in a file of its own.
ExperimentKind distance_kind();
ExperimentKind angle_kind();
ExperimentKind range_kind();
ExperimentKind mosaic_kind();
ExperimentKind false_positives_kind();
ExperimentKind timing_kind();
ExperimentKind families_kind();
ExperimentKind robustness_kind();
ExperimentKind codec_kind();

}  // namespace tagmint::evaluate
