#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/family_kinds/family_kind.h"

namespace tagmint::io {

/// Names of tag systems older than AprilTag whose codes are made by a published construction:
/// "aruco-original", "artag", ... (docs/convert.md).
std::vector<std::string> older_system_names();

/// The family of such a system, or nothing for another name.
///   options   name; layout (another border around the same square); the rest is refused
/// Throws std::invalid_argument for options that contradict the system.
std::optional<ReadFamily> find_older_system(std::string_view name,
                                            const FamilyReadOptions& options);

}  // namespace tagmint::io
