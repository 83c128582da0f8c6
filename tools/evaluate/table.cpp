#include "evaluate/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace tagmint::evaluate {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r#") == std::string::npos) return text;
  std::string safe = "\"";
  for (const char c : text) {
    if (c == '"') safe += '"';
    safe += c;
  }
  return safe + '"';
}

std::string text_of(const Cell& cell) {
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return fmt::to_string(*count);
  if (const auto* measure = std::get_if<double>(&cell)) return fmt::format("{:.6g}", *measure);
  if (const auto* word = std::get_if<std::string>(&cell)) return quoted(*word);
  return {};
}

}  // namespace

std::size_t Table::column(std::string_view name) const {
  const auto at = std::find_if(columns.begin(), columns.end(),
                               [&](const Column& column) { return column.name == name; });
  if (at == columns.end()) throw std::logic_error(fmt::format("no column '{}'", name));
  return static_cast<std::size_t>(at - columns.begin());
}

std::optional<double> Table::number(const Row& row, std::string_view name) const {
  const Cell& cell = row.at(column(name));
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*count);
  if (const auto* measure = std::get_if<double>(&cell)) return *measure;
  return std::nullopt;
}

std::string Table::word(const Row& row, std::string_view name) const {
  const auto* word = std::get_if<std::string>(&row.at(column(name)));
  return word != nullptr ? *word : std::string();
}

std::string format_csv(const Table& table, const std::vector<std::string>& preamble) {
  std::string csv;
  for (const std::string& line : preamble) csv += fmt::format("# {}\n", line);
  csv += "# Columns:\n";
  std::size_t widest = 0;
  for (const Column& column : table.columns) widest = std::max(widest, column.name.size());
  for (const Column& column : table.columns) {
    csv += fmt::format("#   {:<{}}  {}\n", column.name, widest, column.meaning);
  }
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    csv += fmt::format("{}{}", i == 0 ? "" : ",", table.columns[i].name);
  }
  csv += '\n';
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      csv += fmt::format("{}{}", i == 0 ? "" : ",", text_of(row[i]));
    }
    csv += '\n';
  }
  return csv;
}

nlohmann::json rows_to_json(const Rows& rows) {
  nlohmann::json all = nlohmann::json::array();
  for (const Row& row : rows) {
    nlohmann::json cells = nlohmann::json::array();
    for (const Cell& cell : row) {
      std::visit(
          [&](const auto& value) {
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>) {
              cells.push_back(nullptr);
            } else {
              cells.push_back(value);
            }
          },
          cell);
    }
    all.push_back(std::move(cells));
  }
  return all;
}

Rows rows_from_json(const nlohmann::json& json) {
  Rows rows;
  for (const nlohmann::json& cells : json) {
    Row& row = rows.emplace_back();
    for (const nlohmann::json& cell : cells) {
      if (cell.is_null()) {
        row.emplace_back();
      } else if (cell.is_number_integer()) {
        row.emplace_back(cell.get<std::int64_t>());
      } else if (cell.is_number()) {
        row.emplace_back(cell.get<double>());
      } else {
        row.emplace_back(cell.get<std::string>());
      }
    }
  }
  return rows;
}

}  // namespace tagmint::evaluate
