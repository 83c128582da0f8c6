#pragma once

#include <string>

#include "cli/family_report.h"

namespace tagmint::cli {

/// The charts of a family's page as HTML figures, each with its numbers in a table that can be
/// opened: distances between tags, distances to the own turns, complexity, false accepts.
std::string report_charts_html(const FamilyReport& report);

}  // namespace tagmint::cli
