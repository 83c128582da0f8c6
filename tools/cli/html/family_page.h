#pragma once

#include <string>

#include "cli/family_report.h"

namespace tagmint::cli {

/// A family as one HTML page that needs nothing else: facts, levels, charts, sizes, how to print
/// and find its tags, and a gallery that can be searched.
///   source   how the commands that the page shows name the family
///   convert  the command that makes `source` of a file that they do not read; or empty
std::string family_page(const FamilyReport& report, const std::string& source,
                        const std::string& convert);

}  // namespace tagmint::cli
