#include "evaluate/curves.h"

#include <fmt/format.h>

#include <algorithm>

namespace tagmint::evaluate {

Column contender_column() { return {"contender", "detector"}; }
Column decimate_column() {
  return {"decimate", "quads are looked for in a picture that many times smaller"};
}

std::vector<plot::Series> curves(const Table& table, const Settings& settings, std::string_view x,
                                 std::string_view y, const std::function<bool(const Row&)>& where) {
  std::vector<plot::Series> all;
  for (const ContenderKind& kind : settings.contenders) {
    plot::Series series{.label = kind.name, .style = kind.style, .spots = {}};
    for (const Row& row : table.rows) {
      if (table.word(row, "contender") != kind.name || (where && !where(row))) continue;
      const auto at = table.number(row, x);
      const auto value = table.number(row, y);
      if (at && value) series.spots.push_back({.x = *at, .y = *value});
    }
    if (!series.spots.empty()) all.push_back(std::move(series));
  }
  return all;
}

std::function<bool(const Row&)> decimated_by(const Table& table, double decimate) {
  return [column = table.column("decimate"), decimate](const Row& row) {
    const auto* value = std::get_if<double>(&row[column]);
    return value != nullptr && *value == decimate;
  };
}

std::vector<plot::Panel> at_both_sizes(const Table& table, const Settings& settings,
                                       const plot::Axis& x, const plot::Axis& y,
                                       std::string_view x_column, std::string_view y_column) {
  std::vector<plot::Panel> panels;
  for (const double decimate : {1.0, 2.0}) {
    plot::Panel panel{.title = decimate == 1 ? "full resolution" : "decimated by 2",
                      .x = x,
                      .y = y,
                      .series = {}};
    panel.series = curves(table, settings, x_column, y_column, decimated_by(table, decimate));
    panels.push_back(std::move(panel));
  }
  return panels;
}

std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += i == 0 ? fmt::format("{:<{}}", row[i], widths[i])
                     : fmt::format("  {:>{}}", row[i], widths[i]);
    }
    text += '\n';
  }
  return text;
}

std::string contestants(const Settings& settings) {
  std::vector<std::string> words;
  for (const ContenderKind& kind : settings.contenders) {
    words.push_back(kind.release.starts_with(kind.name)
                        ? kind.release
                        : fmt::format("{} ({})", kind.name, kind.release));
  }
  return fmt::format("{}", fmt::join(words, "; "));
}

std::string family_words(const codec::Family& family) {
  return fmt::format("family {}: {} tags of {} bits, distance {}; up to {} bits corrected",
                     family.name(), family.size(), family.bits(), family.min_hamming(),
                     usual_max_hamming(family));
}

int samples_of(const Settings& settings, int quick, int full) {
  if (settings.samples > 0) return settings.samples;
  return settings.quick ? quick : full;
}

}  // namespace tagmint::evaluate
