#include "draw/sheet_decor.h"

#include <algorithm>
#include <array>

#include "draw/units.h"

namespace tagmint::draw {
namespace {

constexpr std::array<std::string_view, 4> kLabelFields = {"family", "id", "edge", "outer"};

}  // namespace

std::span<const std::string_view> label_fields() { return kLabelFields; }

std::vector<FieldValue> tag_fields(const TagGroup& group, codec::TagId id,
                                   const char* unit_separator) {
  const double outer = outer_of_edge(group.family->layout(), group.edge_mm);
  return {{"family", group.family->name()},
          {"id", std::uint64_t{id}},
          {"edge", format_mm(group.edge_mm, unit_separator)},
          {"outer", format_mm(outer, unit_separator)}};
}

double header_height_mm(const SheetDecor& decor) {
  return decor.title.empty() ? 0.0 : kTitleHeightMm;
}

double footer_height_mm(const SheetDecor& decor, std::size_t groups) {
  const double notes = decor.notes ? kNoteLineMm * static_cast<double>(groups) : 0.0;
  const double ruler = decor.ruler == RulerPlace::Lying ? kRulerDepthMm : 0.0;
  return notes + ruler > 0 ? notes + ruler + kNoteGapMm : 0.0;
}

double side_width_mm(const SheetDecor& decor) {
  return decor.ruler == RulerPlace::Upright ? kRulerDepthMm + kNoteGapMm : 0.0;
}

double label_height_mm(const SheetDecor& decor, std::span<const TagGroup> groups) {
  if (!decor.label || groups.empty()) return 0.0;
  double smallest = outer_of_edge(groups[0].family->layout(), groups[0].edge_mm);
  for (const TagGroup& group : groups) {
    smallest = std::min(smallest, outer_of_edge(group.family->layout(), group.edge_mm));
  }
  return std::clamp(0.12 * smallest, 2.2, 5.0);
}

}  // namespace tagmint::draw
