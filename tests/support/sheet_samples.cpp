#include "support/sheet_samples.h"

#include <numeric>

#include "draw/units.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::test {

SampleSheet sample_sheet(const std::string& family, double edge_mm, std::size_t count) {
  draw::TagGroup group{codec::find_family(family), edge_mm, std::vector<codec::TagId>(count)};
  std::iota(group.ids.begin(), group.ids.end(), codec::TagId{0});
  const draw::SheetDecor decor{.label = draw::TextFormat("{family} {id:05}", draw::label_fields()),
                               .title = "Sample & <title>",
                               .notes = true,
                               .ruler = draw::RulerPlace::Lying,
                               .cut_marks = true};
  const std::vector<draw::TagGroup> groups = {group};
  const draw::SheetOptions options{.label_mm = draw::label_height_mm(decor, groups),
                                   .header_mm = draw::header_height_mm(decor),
                                   .footer_mm = draw::footer_height_mm(decor, 1)};
  return {draw::plan_sheet(groups, options), decor};
}

detect::Corners planned_corners(const draw::SheetPlan& plan, const draw::PlacedTag& tag,
                                double dpi) {
  const double scale = dpi / draw::kMmAnInch;
  const double edge = plan.groups[tag.group].edge_mm * scale;
  const double border = (tag.outer.width_mm * scale - edge) / 2;
  const double left = tag.outer.x_mm * scale + border;
  const double top = tag.outer.y_mm * scale + border;
  return {{{left, top + edge}, {left + edge, top + edge}, {left + edge, top}, {left, top}}};
}

}  // namespace tagmint::test
