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
std::string bar(std::uint64_t count, std::uint64_t largest) {
  const double share = static_cast<double>(count) / static_cast<double>(largest);
  return std::string(std::max<std::size_t>(1, static_cast<std::size_t>(share * kBarWidth)), '#');
}

using Bars = std::vector<std::pair<std::string, std::uint64_t>>;

std::string histogram(const std::string& title, const Bars& bars) {
  if (bars.empty()) return "";
  const auto largest = std::max_element(
      bars.begin(), bars.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, count] : bars) {
    rows.push_back({name, fmt::to_string(count), bar(count, largest->second)});
  }
  return "\n" + title + "\n" + format_table({kRight, kRight, kLeft}, rows, kIndent);
}

Bars bars_of(const std::vector<std::uint64_t>& counts) {
  Bars bars;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) bars.emplace_back(fmt::to_string(i), counts[i]);
  }
  return bars;
}

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

std::string summary(const FamilyReport& report) {
  const codec::Family& family = *report.family;
  const codec::Layout& layout = family.layout();
  std::vector<std::vector<std::string>> rows = {
      {"codes", fmt::to_string(family.size())},
      {"bits", fmt::to_string(family.bits())},
      {"distance",
       fmt::format("{} (declared), {} (found)", family.min_hamming(), report.stats.min_hamming)},
      {"safe radius", fmt::format("{} bit errors", family.max_safe_errors())},
      {"layout", codec::layout_name(layout)},
      {"edge", fmt::format("{} of {} cells, {}", layout.width_at_border(), layout.width(),
                           layout.reversed_border() ? "white inside black" : "black inside white")},
      {"complexity", codec::to_string(family.complexity())},
      {"origin", origin_text(family.origin())},
      {"sha256", report.digest}};
  if (family.levels().size() > 1) rows.push_back({"levels", levels_text(family)});
  return family.name() + "\n" + format_table({kLeft, kLeft}, rows, kIndent);
}

/// The rates up to two bits above the safe radius: beyond it, errors may also give a wrong id.
std::string false_accepts(const FamilyReport& report) {
  const auto& rates = report.stats.false_accept_rate;
  const auto safe = static_cast<std::size_t>(report.family->max_safe_errors());
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

std::string family_report_text(const FamilyReport& report) {
  Bars complexity;
  for (const auto& [value, tags] : report.complexity_histogram) {
    complexity.emplace_back(fmt::format("{:.4g}", value), tags);
  }
  return summary(report) +
         histogram("Pairs of tags by Hamming distance (least of the four rotations)",
                   bars_of(report.stats.distance_histogram)) +
         histogram("Tags by distance to their own turns", bars_of(report.stats.self_histogram)) +
         histogram(fmt::format("Tags by complexity ({})", report.complexity_measure), complexity) +
         false_accepts(report) + lookup(report);
}

}  // namespace tagmint::cli
