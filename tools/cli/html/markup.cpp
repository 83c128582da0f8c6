#include "cli/html/markup.h"

#include <fmt/format.h>

#include <iterator>

namespace tagmint::cli {
namespace {

std::string table_row(const std::vector<TableCell>& cells, std::string_view tag) {
  std::string row = "<tr>";
  for (const TableCell& cell : cells) {
    row += fmt::format("<{0}{1}{2}>{3}</{0}>", tag, tag == "th" ? " scope=\"col\"" : "",
                       cell.left ? " class=\"text\"" : "", escaped(cell.text));
  }
  return row + "</tr>\n";
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string grouped(std::uint64_t count) {
  std::string digits = fmt::to_string(count);
  for (std::ptrdiff_t at = std::ssize(digits) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), 1, ',');
  }
  return digits;
}

std::string html_table(std::string_view caption, const std::vector<TableCell>& header,
                       const std::vector<std::vector<TableCell>>& rows) {
  std::string html =
      fmt::format("<div class=\"scroll\"><table aria-label=\"{}\">\n<thead>\n{}</thead>\n<tbody>\n",
                  escaped(caption), table_row(header, "th"));
  for (const auto& row : rows) html += table_row(row, "td");
  return html + "</tbody>\n</table></div>\n";
}

}  // namespace tagmint::cli
