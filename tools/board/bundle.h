#pragma once

#include <vector>

#include "board/board.h"

namespace tagmint::board {

/// A board of tags of any families and sizes at places of their own. Its origin and axes are those
/// that the places are given in. A tag whose place, quiet zone included, lies in the hole of
/// another gets that one as its host.
///   tags   layout as the family's, at least one; `host` is set here
/// Throws draw::DoesNotFit for tags that stand too near to each other; std::invalid_argument for
/// none, numbers that are not finite, an edge that is not positive, an id that is not the family's,
/// or a tag that occurs twice.
Board plan_bundle(std::vector<BoardTag> tags);

}  // namespace tagmint::board
