#include "cli/family_text.h"

#include <fmt/format.h>

#include "tagmint/codec/layout_presets.h"

namespace tagmint::cli {

nlohmann::ordered_json family_summary_json(const codec::Family& family) {
  nlohmann::ordered_json levels = nlohmann::ordered_json::array();
  for (const codec::Level& level : family.levels()) {
    levels.push_back({{"codes", level.codes}, {"min_hamming", level.min_hamming}});
    if (level.plain > 0) levels.back()["plain"] = level.plain;
  }
  return {{"name", family.name()},
          {"bits", family.bits()},
          {"codes", family.size()},
          {"min_hamming", family.min_hamming()},
          {"safe_radius", family.max_safe_errors()},
          {"layout", codec::layout_name(family.layout())},
          {"width_at_border", family.layout().width_at_border()},
          {"total_width", family.layout().width()},
          {"levels", levels}};
}

std::string levels_text(const codec::Family& family) {
  if (family.levels().size() == 1) return "-";
  std::string text;
  for (const codec::Level& level : family.levels()) {
    text += fmt::format("{}{} at {}", text.empty() ? "" : ", ", level.codes, level.min_hamming);
  }
  return text;
}

}  // namespace tagmint::cli
