#pragma once

#include <string_view>
#include <vector>

namespace tagmint::io {

/// A line of a text without the blanks around it.
struct TextLine {
  std::string_view text;
  int number = 0;  ///< from 1
};

/// The lines of a text that are not blank. The views are into `content`.
inline std::vector<TextLine> text_lines(std::string_view content) {
  constexpr std::string_view kBlank = " \t\r";
  std::vector<TextLine> lines;
  for (int number = 1; !content.empty(); ++number) {
    const std::size_t end = content.find('\n');
    const std::string_view line = content.substr(0, end);
    content.remove_prefix(end == std::string_view::npos ? content.size() : end + 1);
    const std::size_t first = line.find_first_not_of(kBlank);
    if (first == std::string_view::npos) continue;
    lines.push_back({line.substr(first, line.find_last_not_of(kBlank) + 1 - first), number});
  }
  return lines;
}

}  // namespace tagmint::io
