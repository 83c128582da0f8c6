#include "cli/paper.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/length.h"
#include "cli/number.h"
#include "draw/sheet_plan.h"
#include "tagmint/codec/suggest.h"

namespace tagmint::cli {
namespace {

struct NamedPaper {
  std::string_view name;
  PaperSize size;
};

// ISO 216 and the North American sizes, 8.5 x 11, 8.5 x 14 and 11 x 17 in.
constexpr std::array<NamedPaper, 10> kPapers = {{{"a0", {841, 1189}},
                                                 {"a1", {594, 841}},
                                                 {"a2", {420, 594}},
                                                 {"a3", {297, 420}},
                                                 {"a4", {210, 297}},
                                                 {"a5", {148, 210}},
                                                 {"a6", {105, 148}},
                                                 {"letter", {215.9, 279.4}},
                                                 {"legal", {215.9, 355.6}},
                                                 {"tabloid", {279.4, 431.8}}}};

/// "100x150mm": two numbers, and the unit of both at the end.
PaperSize parse_sides(std::string_view text, std::string_view option) {
  const std::size_t cross = text.find('x');
  const std::string_view second = text.substr(cross + 1);
  const auto number = leading_number(trimmed(second));
  const std::string unit(number ? number->rest : "");
  const std::string_view first = text.substr(0, cross);
  const bool has_unit = !first.empty() && std::isalpha(static_cast<unsigned char>(first.back()));
  const PaperSize size{
      parse_length_mm(has_unit ? std::string(first) : std::string(first) + unit, option),
      parse_length_mm(second, option)};
  for (const double side : {size.width_mm, size.height_mm}) {
    if (side <= 0 || side > draw::kMaxPageMm) {
      throw UsageError(fmt::format("a page of '{}' cannot be", text), option,
                       fmt::format("sides are above 0 and at most {} mm", draw::kMaxPageMm));
    }
  }
  return size;
}

}  // namespace

PaperSize parse_paper(std::string_view text, std::string_view option) {
  std::string name(text);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* const paper = std::find_if(kPapers.begin(), kPapers.end(),
                                         [&](const NamedPaper& p) { return p.name == name; });
  if (paper != kPapers.end()) return paper->size;
  if (!name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) &&
      name.find('x') != std::string::npos) {
    return parse_sides(name, option);
  }
  std::vector<std::string> names;
  for (const NamedPaper& p : kPapers) names.emplace_back(p.name);
  const std::string hint = codec::did_you_mean(name, names);
  throw UsageError(fmt::format("unknown paper '{}'", text), option,
                   fmt::format("{}{}use one of {}, or sides like 100x150mm", hint,
                               hint.empty() ? "" : " ", fmt::join(names, ", ")));
}

}  // namespace tagmint::cli
