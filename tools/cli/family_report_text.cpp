#include <fmt/format.h>

#include <algorithm>

#include "cli/family_report.h"
#include "cli/family_text.h"
#include "cli/text_table.h"
#include "tagmint/codec/complexity.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::cli {
namespace {

constexpr Align kLeft = Align::Left;
constexpr Align kRight = Align::Right;
constexpr int kIndent = 2;
constexpr double kBarWidth = 40.0;

/// A bar whose length shows a share of the largest count; every count above zero shows.
std::string bar(double count, double largest) {
  const double share = count / largest;
  return std::string(std::max<std::size_t>(1, static_cast<std::size_t>(share * kBarWidth)), '#');
}

/// One line of a histogram: what is counted, how often, and that as text.
struct Bar {
  std::string name;
  double count = 0;
  std::string text;
};
using Bars = std::vector<Bar>;

Bar whole_bar(std::string name, std::uint64_t count) {
  return {std::move(name), static_cast<double>(count), fmt::to_string(count)};
}

std::string histogram(const std::string& title, const Bars& bars) {
  if (bars.empty()) return "";
  const auto largest = std::max_element(
      bars.begin(), bars.end(), [](const Bar& a, const Bar& b) { return a.count < b.count; });
  std::vector<std::vector<std::string>> rows;
  for (const Bar& each : bars) {
    rows.push_back({each.name, each.text, bar(each.count, largest->count)});
  }
  return "\n" + title + "\n" + format_table({kRight, kRight, kLeft}, rows, kIndent);
}

Bars bars_of(const std::vector<std::uint64_t>& counts) {
  Bars bars;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) bars.push_back(whole_bar(fmt::to_string(i), counts[i]));
  }
  return bars;
}

/// Averages; whole ones are written whole.
Bars bars_of(const std::vector<double>& averages) {
  Bars bars;
  for (std::size_t i = 0; i < averages.size(); ++i) {
    const double count = averages[i];
    if (count > 0) bars.push_back({fmt::to_string(i), count, fmt::format("{:.10g}", count)});
  }
  return bars;
}

std::string distances(const FamilyReport& report) {
  if (report.family->is_listed()) {
    return histogram("Pairs of tags by Hamming distance (least of the four rotations)",
                     bars_of(report.stats.distance_histogram));
  }
  const bool average = report.family->generator()->cosets().size() > 1;
  return histogram(
      fmt::format("Words of the code by Hamming distance from one of them{}; each turn of a tag is "
                  "a word",
                  average ? " (average)" : ""),
      bars_of(report.stats.word_distances));
}

std::string safe_radius_text(const FamilyReport& report) {
  const auto safe = report.safe_errors();
  if (!safe) return "none: even without an error tags or their turns are taken for each other";
  return fmt::format("{} bit error{}", *safe, *safe == 1 ? "" : "s");
}

std::string summary(const FamilyReport& report) {
  const codec::Family& family = *report.family;
  const codec::Layout& layout = family.layout();
  std::vector<std::vector<std::string>> rows = {
      {"codes", fmt::to_string(family.size())},
      {"bits", fmt::to_string(family.bits())},
      {"distance",
       fmt::format("{} (declared), {} (found)", family.min_hamming(), report.stats.min_hamming)},
      {"between tags", nearest_text(report)},
      {"own turns", fmt::format("{} bits", report.self_distance)},
      {"safe radius", safe_radius_text(report)},
      {"layout", codec::layout_name(layout)},
      {"edge", fmt::format("{} of {} cells, {}", layout.width_at_border(), layout.width(),
                           layout.reversed_border() ? "white inside black" : "black inside white")},
      {"complexity", complexity_text(report)},
      {"origin", origin_text(family.origin())},
      {"sha256", report.digest}};
  return family.name() + "\n" + format_table({kLeft, kLeft}, rows, kIndent);
}

/// One row a level of a family that has several.
std::string levels(const FamilyReport& report) {
  const codec::Family& family = *report.family;
  if (family.levels().size() == 1) return "";
  std::vector<std::vector<std::string>> rows = {{"ids", "tags", "distance", "found", "safe radius",
                                                 "at 0 bits", "at 2 bits", "at the safe radius",
                                                 "pass complexity"}};
  for (std::size_t i = 0; i < family.levels().size(); ++i) {
    const codec::Level& level = family.levels()[i];
    const codec::LevelStats& found = report.stats.levels[i];
    const int safe = (level.min_hamming - 1) / 2;
    const auto rate = [&](int errors) {
      return fmt::format("{:.3g}", codec::false_accept_rate(level.codes, family.bits(), errors));
    };
    rows.push_back({fmt::format("0-{}", level.codes - 1), fmt::to_string(level.codes),
                    fmt::to_string(level.min_hamming), fmt::to_string(found.min_hamming),
                    fmt::to_string(safe), rate(0), rate(std::min(2, family.bits())), rate(safe),
                    fmt::to_string(found.passing)});
  }
  return "\nLevels, with the false-accept rate of random words by corrected bits\n" +
         format_table(std::vector<Align>(rows.front().size(), kRight), rows, kIndent);
}

/// The rates up to two bits above the safe radius: beyond it, errors may also give a wrong id.
std::string false_accepts(const FamilyReport& report) {
  const auto& rates = report.stats.false_accept_rate;
  const auto safe = static_cast<std::size_t>(report.safe_errors().value_or(0));
  std::vector<std::vector<std::string>> rows;
  for (std::size_t bits = 0; bits < std::min(rates.size(), safe + 3); ++bits) {
    rows.push_back({fmt::to_string(bits), fmt::format("{:.3g}", rates[bits]),
                    bits > safe ? "above the safe radius" : ""});
  }
  return "\nFalse-accept rate of random words, by corrected bits\n" +
         format_table({kRight, kLeft, kLeft}, rows, kIndent);
}

std::string lookup(const FamilyReport& report) {
  std::vector<std::vector<std::string>> rows;
  for (const LookupMemory& memory : report.lookup) {
    rows.push_back({engine_name(memory.engine), fmt::format("{} bits", memory.max_errors),
                    fmt::format("{:.1f} KiB", static_cast<double>(memory.bytes) / 1024.0)});
  }
  return "\nMemory of the lookup, by corrected bits\n" +
         format_table({kLeft, kLeft, kRight}, rows, kIndent);
}

}  // namespace

std::string origin_text(const codec::Origin& origin) {
  std::string text;
  const auto add = [&text](const std::string& label, const std::string& value) {
    if (!value.empty()) text += fmt::format("{}{}{}", text.empty() ? "" : ", ", label, value);
  };
  add("", origin.method);
  add("order ", origin.order);
  add("seed ", origin.seed);
  add("searched ", origin.searched);
  add("by ", origin.program);
  return text.empty() ? "not known" : text;
}

std::string complexity_text(const FamilyReport& report) {
  const std::size_t tags = report.family->size();
  const std::size_t passing = report.stats.levels.back().passing;
  const std::string rule = codec::to_string(report.family->complexity());
  return passing == tags ? rule : fmt::format("{}; {} of {} tags pass", rule, passing, tags);
}

std::string nearest_text(const FamilyReport& report) {
  if (!report.between) {
    return fmt::format("{} bits between words of the code", report.stats.min_hamming);
  }
  const std::uint64_t pairs = report.stats.distance_histogram[*report.between];
  std::string ids;
  for (const codec::NearPair& pair : report.nearest) {
    ids += fmt::format("{}{} and {}", ids.empty() ? "" : ", ", pair.first, pair.second);
  }
  return fmt::format("{} bits: {}{}", *report.between, ids,
                     pairs > report.nearest.size() ? fmt::format(", ... of {} pairs", pairs) : "");
}

std::string family_report_text(const FamilyReport& report) {
  Bars complexity;
  for (const auto& [value, tags] : report.complexity_histogram) {
    complexity.push_back(whole_bar(fmt::format("{:.4g}", value), tags));
  }
  return summary(report) + levels(report) + distances(report) +
         histogram("Tags by distance to their own turns", bars_of(report.stats.self_histogram)) +
         histogram(fmt::format("Tags by complexity ({})", report.complexity_measure), complexity) +
         false_accepts(report) + lookup(report);
}

}  // namespace tagmint::cli
