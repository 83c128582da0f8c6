#include "tagmint/codec/complexity.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "colour_changes.h"
#include "rectangle_painter.h"
#include "tagmint/codec/suggest.h"

namespace tagmint::codec {
namespace {

constexpr int kNoLimit = std::numeric_limits<int>::max();

constexpr std::array kRules = {ComplexityRule::Rectangles, ComplexityRule::Energy,
                               ComplexityRule::None};

ComplexityRule parse_rule(std::string_view name) {
  std::vector<std::string> names;
  for (const ComplexityRule rule : kRules) {
    if (rule_name(rule) == name) return rule;
    names.emplace_back(rule_name(rule));
  }
  std::string hint = did_you_mean(name, names);
  if (!hint.empty()) hint += ' ';
  throw std::invalid_argument(fmt::format(
      "unknown complexity rule '{}'; {}rules are rectangles:N, energy:F and none", name, hint));
}

/// The number after the colon; nothing when `text` is not a number as a whole.
std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::string_view rule_name(ComplexityRule rule) {
  switch (rule) {
    case ComplexityRule::Rectangles:
      return "rectangles";
    case ComplexityRule::Energy:
      return "energy";
    case ComplexityRule::None:
      break;
  }
  return "none";
}

Complexity parse_complexity(std::string_view text) {
  const std::size_t colon = text.find(':');
  const ComplexityRule rule = parse_rule(text.substr(0, colon));
  const bool has_threshold = colon != std::string_view::npos;
  if (rule == ComplexityRule::None) {
    if (has_threshold) {
      throw std::invalid_argument(
          fmt::format("complexity '{}' has a threshold; the rule none takes nothing", text));
    }
    return {};
  }
  const std::optional<double> threshold =
      has_threshold ? parse_number(text.substr(colon + 1)) : std::nullopt;
  if (rule == ComplexityRule::Rectangles) {
    if (!threshold || *threshold < 1 || *threshold > kNoLimit ||
        *threshold != std::floor(*threshold)) {
      throw std::invalid_argument(fmt::format(
          "complexity '{}' needs a whole number of rectangles of at least 1, like rectangles:10",
          text));
    }
  } else if (!threshold || !(*threshold > 0 && *threshold <= 1)) {
    throw std::invalid_argument(fmt::format(
        "complexity '{}' needs a share above 0 and at most 1, like energy:0.3333", text));
  }
  return {rule, *threshold};
}

std::string to_string(const Complexity& complexity) {
  if (complexity.rule == ComplexityRule::None) return "none";
  return fmt::format("{}:{}", rule_name(complexity.rule), complexity.threshold);
}

int count_rectangles(const Layout& layout, Codeword word) {
  return RectanglePainter(layout).count(word, kNoLimit);
}

int count_colour_changes(const Layout& layout, Codeword word) {
  return ColourChanges(layout).count(word);
}

struct ComplexityJudge::Tables {
  explicit Tables(const Layout& layout) : painter(layout), changes(layout) {}
  RectanglePainter painter;
  ColourChanges changes;
};

ComplexityJudge::ComplexityJudge(const Layout& layout, const Complexity& complexity)
    : complexity_(complexity), tables_(std::make_shared<const Tables>(layout)) {}

bool ComplexityJudge::accepts(Codeword word) const {
  switch (complexity_.rule) {
    case ComplexityRule::Rectangles: {
      // The painter may stop as soon as it has needed enough.
      const int needed = static_cast<int>(std::ceil(complexity_.threshold));
      return tables_->painter.count(word, needed) >= needed;
    }
    case ComplexityRule::Energy:
      return tables_->changes.count(word) >= complexity_.threshold * 2 * tables_->changes.cells();
    case ComplexityRule::None:
      break;
  }
  return true;
}

double ComplexityJudge::measure(Codeword word) const {
  switch (complexity_.rule) {
    case ComplexityRule::Rectangles:
      return tables_->painter.count(word, kNoLimit);
    case ComplexityRule::Energy:
      return tables_->changes.count(word) / (2.0 * tables_->changes.cells());
    case ComplexityRule::None:
      break;
  }
  return 0;
}

}  // namespace tagmint::codec
