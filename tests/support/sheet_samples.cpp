#include "support/sheet_samples.h"

#include <numeric>

#include "tagmint/codec/builtin_families.h"

namespace tagmint::test {

SampleSheet sample_sheet(const std::string& family, double edge_mm, std::size_t count) {
  draw::TagGroup group{codec::find_family(family), edge_mm, std::vector<codec::TagId>(count)};
  std::iota(group.ids.begin(), group.ids.end(), codec::TagId{0});
  const draw::SheetDecor decor{.label = draw::TextFormat("{family} {id:05}", draw::label_fields()),
                               .title = "Sample & <title>",
                               .notes = true,
                               .ruler = true,
                               .cut_marks = true};
  const std::vector<draw::TagGroup> groups = {group};
  const draw::SheetOptions options{.label_mm = draw::label_height_mm(decor, groups),
                                   .header_mm = draw::header_height_mm(decor),
                                   .footer_mm = draw::footer_height_mm(decor, 1)};
  return {draw::plan_sheet(groups, options), decor};
}

}  // namespace tagmint::test
