#pragma once

#include <string_view>

namespace tagmint::cli {

/// Sides of a page.
struct PaperSize {
  double width_mm = 0.0;
  double height_mm = 0.0;
};

/// A page from its name (a0..a6, letter, legal, tabloid; upright) or its sides, "100x150mm".
///   option   named in the message, for example "--paper"
/// Throws UsageError, also for a side that is zero or longer than draw::kMaxPageMm.
PaperSize parse_paper(std::string_view text, std::string_view option = "--paper");

}  // namespace tagmint::cli
