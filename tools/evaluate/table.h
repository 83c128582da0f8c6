#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tagmint::evaluate {

/// A value of a table: nothing (it could not be measured), a count, a measure or a word.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string>;
using Row = std::vector<Cell>;
using Rows = std::vector<Row>;

/// A measure that may be missing, as a cell.
inline Cell cell_of(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }

/// A column of an experiment's table.
struct Column {
  std::string name;     ///< lower case, ends in its unit: "distance_m"
  std::string meaning;  ///< one line
};

/// What an experiment found.
struct Table {
  std::vector<Column> columns;
  Rows rows;

  /// Index of a column. Throws std::logic_error for a name that there is not.
  std::size_t column(std::string_view name) const;
  /// The number in a row; nothing where there is none.
  std::optional<double> number(const Row& row, std::string_view name) const;
  std::string word(const Row& row, std::string_view name) const;
};

/// The table as CSV [RFC 4180], with lines that begin with '#' before it: `preamble`, then each
/// column and its meaning. Measures have six significant digits; missing ones are empty.
std::string format_csv(const Table& table, const std::vector<std::string>& preamble);

/// Rows as JSON, digit for digit, and back. Throws nlohmann's errors for what are no rows.
nlohmann::json rows_to_json(const Rows& rows);
Rows rows_from_json(const nlohmann::json& json);

}  // namespace tagmint::evaluate
