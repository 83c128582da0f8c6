#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tagmint/codec/family.h"

namespace tagmint::cli {

/// The figures of a family that every JSON listing gives: name, bits, codes (a count), min_hamming,
/// safe_radius, layout (its name), width_at_border and total_width in cells, levels (with "plain"
/// where some of a level's own tags fail the complexity rule).
nlohmann::ordered_json family_summary_json(const codec::Family& family);

/// "60 at 16, 2016 at 12": the levels of a nested family; "-" where the family is one level.
std::string levels_text(const codec::Family& family);

}  // namespace tagmint::cli
