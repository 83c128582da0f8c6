#pragma once

#include <string>
#include <vector>

#include "evaluate/run.h"

namespace tagmint::cli {

/// What became of a family in evaluate::family_trial_kind(), beside tag36h11, as one HTML page that
/// needs nothing else: both families, how they are found by size, angle and noise (figure and
/// table), what is taken for their tags.
///   command   that makes the page again
std::string trial_page(const codec::Family& family, const evaluate::Outcome& outcome,
                       const std::vector<std::string>& conditions, const std::string& command);

}  // namespace tagmint::cli
