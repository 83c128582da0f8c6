#pragma once

#include <string>
#include <vector>

namespace tagmint::cli {

/// Where the text of a table column stands.
enum class Align { Left, Right };

/// Rows of text in columns, two spaces apart, without spaces at line ends.
///   align   one entry a column
///   rows    each as long as `align`; the first may be the header
///   indent  spaces before each line
std::string format_table(const std::vector<Align>& align,
                         const std::vector<std::vector<std::string>>& rows, int indent = 0);

}  // namespace tagmint::cli
