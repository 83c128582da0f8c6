#pragma once

#include <optional>
#include <string>

#include "identify/identify.h"

namespace tagmint::cli {

/// The dictionary of OpenCV 4 that has the same tags with the same ids, and how far the tag is
/// turned by its measure.
struct OpenCvName {
  std::string dictionary;
  double turned_deg = 0;  ///< clockwise, 0 <= . < 360
};
std::optional<OpenCvName> opencv_name(const identify::Candidate& candidate);

/// "whole", "cut" or "none".
std::string border_word(identify::BorderPart border);

}  // namespace tagmint::cli
