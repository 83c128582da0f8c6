#pragma once

#include <vector>

#include "tagmint/codec/complexity.h"
#include "tagmint/codec/layout.h"
#include "tagmint/codec/search/order.h"

namespace tagmint::cli {

/// Whether the layout is one of classic:W: they are searched as the published classic families
/// were.
bool is_classic(const codec::Layout& layout);

/// The walk of the published families of that look: AprilTag2 for classic layouts, else AprilTag3.
codec::Order default_order(const codec::Layout& layout);

/// For classic layouts at least ceil(5 (d - 2) / 2) rectangles, where d is the side of the data
/// square in cells: the published 5, 8, 10 for d = 4, 5, 6, carried on in a straight line, and at
/// least 1. Else the energy 0.3333 of the AprilTag 3 families.
codec::Complexity default_complexity(const codec::Layout& layout);

/// The orders of `attempts` searches: `first`, and then codeword order with the seeds that follow
/// the first one's. `attempts` >= 1.
std::vector<codec::Order> attempt_orders(const codec::Order& first, const codec::Layout& layout,
                                         int min_hamming, const codec::Complexity& complexity,
                                         int attempts);

}  // namespace tagmint::cli
