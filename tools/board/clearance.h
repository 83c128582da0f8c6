#pragma once

#include <vector>

#include "board/board.h"

namespace tagmint::board {

/// Side of the tag with its quiet zone: nothing else may be printed in there.
double quiet_side_mm(const BoardTag& tag);

/// Side of the smallest square around the tag's middle that holds all cells which may be black.
double ink_side_mm(const BoardTag& tag);

/// The least gap between border squares of neighbours in a row or column: no black cell of one
/// reaches the quiet zone of the other.
double least_gap_mm(const codec::Layout& layout, double edge_mm);

/// A rectangle that holds the tags with their quiet zones.
///   tags   at least one
draw::Box extent_of(const std::vector<BoardTag>& tags);

/// Finds the tags that stand in the hole of another, sets their `host`, and checks that no tag
/// reaches into the quiet zone of another. Throws draw::DoesNotFit naming two that do;
/// std::invalid_argument when a tag occurs twice.
///   cost   quadratic in the tags
void check_clearance(std::vector<BoardTag>& tags);

/// Throws std::invalid_argument when a tag, family and id, occurs twice: a detector could not tell
/// which of them it saw.
void check_each_once(const std::vector<BoardTag>& tags);

}  // namespace tagmint::board
