#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tagmint::cli {

/// The text with '&', '<', '>' and '"' as entities: fit for content and quoted attributes.
std::string escaped(std::string_view text);

/// "65,535".
std::string grouped(std::uint64_t count);

/// A cell of a table; its text is escaped by html_table().
struct TableCell {
  std::string text;
  bool left = false;  ///< words, not a figure: stands at the left
};

/// A table that scrolls sideways where there is too little room.
///   header   one cell a column
std::string html_table(std::string_view caption, const std::vector<TableCell>& header,
                       const std::vector<std::vector<TableCell>>& rows);

}  // namespace tagmint::cli
