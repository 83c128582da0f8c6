#pragma once

#include <optional>
#include <span>
#include <vector>

#include "draw/sheet_plan.h"
#include "tagmint/codec/family.h"

namespace tagmint::draw {

/// A smaller tag in the hole of a larger one, as it is asked for.
struct NestedRequest {
  codec::SharedFamily family;
  codec::TagId id = 0;
  std::optional<double> edge_mm;  ///< nothing = the largest that the hole takes
};

/// Side in cells of the square in the middle of a layout that is not part of the tag (Cell::None);
/// 0 where there is none.
int hole_cells(const codec::Layout& layout);

/// Side of the whole tag and its quiet zone for a border square of side `edge_mm`.
double side_with_quiet_zone(const codec::Layout& layout, double edge_mm);

/// The edges of tags that stand one inside another, from the outermost inwards: each request goes
/// into the hole of the one before it, the first into the host's, with its whole quiet zone.
///   host_edge_mm   side of the host's border square
///   returns        one edge a request, mm
/// Throws DoesNotFit for a tag without a hole or an edge too large for it, naming the largest;
/// std::invalid_argument for an edge that is not positive or an id that its family does not have.
std::vector<double> nested_edges(const codec::Family& host, double host_edge_mm,
                                 std::span<const NestedRequest> requests);

}  // namespace tagmint::draw
