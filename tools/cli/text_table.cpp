#include "cli/text_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace tagmint::cli {

std::string format_table(const std::vector<Align>& align,
                         const std::vector<std::vector<std::string>>& rows, int indent) {
  std::vector<std::size_t> widths(align.size(), 0);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line(static_cast<std::size_t>(indent), ' ');
    for (std::size_t i = 0; i < widths.size(); ++i) {
      if (i > 0) line += "  ";
      line += align[i] == Align::Left ? fmt::format("{:<{}}", row[i], widths[i])
                                      : fmt::format("{:>{}}", row[i], widths[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace tagmint::cli
