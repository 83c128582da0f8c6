#pragma once

#include "evaluate/experiment.h"

namespace tagmint::evaluate {

/// The family of the settings beside tag36h11: found by size, angle and noise, and how often it is
/// mistaken. Not among experiment_kinds(): its files are named "family".
ExperimentKind family_trial_kind();

/// What a family is set beside.
inline constexpr const char* kYardstickFamily = "tag36h11";

/// Rows of its table by what was measured: column "measure".
inline constexpr const char* kBySize = "size";      ///< level: side of the whole tag, px
inline constexpr const char* kByAngle = "angle";    ///< level: off-axis angle, degrees
inline constexpr const char* kByNoise = "noise";    ///< level: sigma, gray levels
inline constexpr const char* kWords = "words";      ///< level: bits corrected; random words
inline constexpr const char* kClutter = "clutter";  ///< level: 0; quads of pictures without tags

}  // namespace tagmint::evaluate
