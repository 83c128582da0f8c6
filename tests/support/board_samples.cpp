#include "support/board_samples.h"

#include <numeric>
#include <vector>

#include "board/bundle.h"
#include "board/grid_board.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::test {

using board::Board;
using board::make_tag;
using codec::find_family;

Board sample_grid(const std::string& family, const board::Grid& grid, codec::TagId first) {
  std::vector<codec::TagId> ids(static_cast<std::size_t>(grid.columns) * grid.rows);
  std::iota(ids.begin(), ids.end(), first);
  return board::plan_grid(find_family(family), grid, ids);
}

Board kalibr_board() {
  return sample_grid("tag36h11", {.columns = 3,
                                  .rows = 2,
                                  .edge_mm = 40,
                                  .gap_mm = 12,
                                  .style = board::Style::Kalibr,
                                  .border_cells = 2});
}

Board sample_bundle() {
  const auto family = find_family("tag36h11");
  return board::plan_bundle(
      {make_tag(family, 0, 48, {0, 0}), make_tag(family, 12, 24, {60, -21.5}, 90),
       make_tag(family, 7, 24, {61.25, 30}, -37.5), make_tag(family, 586, 32, {-55, 4.125}, 180)});
}

Board mixed_bundle() {
  return board::plan_bundle({make_tag(find_family("tagCustom48h12"), 21, 90, {0, 0}),
                             make_tag(find_family("tag36h11"), 7, 24, {0, 0}),
                             make_tag(find_family("tag25h9"), 3, 28, {110, -60}, 20),
                             make_tag(find_family("tag36h11"), 8, 24, {110, 0})});
}

}  // namespace tagmint::test
