#pragma once

#include <string_view>
#include <vector>

#include "tagmint/detect/camera.h"

namespace tagmint::cli {

/// Numbers separated by commas, "600,600,320,240".
///   count    how many there must be
///   option   named in the message
///   names    what they are, for the message: "FX,FY,CX,CY"
/// Throws UsageError.
std::vector<double> parse_numbers(std::string_view text, std::size_t count, std::string_view option,
                                  std::string_view names);

/// The camera of --camera FX,FY,CX,CY and --distortion K1,K2,P1,P2,K3 (empty = none); pixels, with
/// (0.5, 0.5) the centre of the first pixel. Throws UsageError.
detect::Camera parse_camera(std::string_view camera, std::string_view distortion);

}  // namespace tagmint::cli
