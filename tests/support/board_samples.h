#pragma once

#include <string>

#include "board/board.h"

namespace tagmint::test {

/// A grid of tags from `first` on.
board::Board sample_grid(const std::string& family, const board::Grid& grid,
                         codec::TagId first = 0);

/// 3 x 2 tags of edge 40 mm as Kalibr prints them, spacing 0.3.
board::Board kalibr_board();

/// Tags of one family: two sizes, turns that are no quarter turns.
board::Board sample_bundle();

/// Tags of three families; one stands in the hole of another.
board::Board mixed_bundle();

}  // namespace tagmint::test
