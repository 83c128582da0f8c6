#pragma once

#include <cstddef>
#include <string>

#include "cli/family_report.h"

namespace tagmint::cli {

/// Codewords that a page carries; of larger families it shows the first ones and says so. A page
/// with so many of 64 bits has 2.4 MB.
inline constexpr std::size_t kMostInGallery = 150'000;
/// Tags that the page shows before its script runs, or where it does not run.
inline constexpr std::size_t kDrawnInGallery = 12;

/// The searchable gallery: its elements, the codewords as JSON and the script that draws them.
std::string gallery_html(const FamilyReport& report);

}  // namespace tagmint::cli
