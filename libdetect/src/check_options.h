#pragma once

#include "tagmint/detect/detector_options.h"

namespace tagmint::detect {

/// Throws std::invalid_argument that names the first option out of its range, its value and the
/// range.
void check_options(const DetectorOptions& options);

}  // namespace tagmint::detect
