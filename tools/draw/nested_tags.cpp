#include "draw/nested_tags.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "draw/units.h"

namespace tagmint::draw {
namespace {

// Lengths are told rounded to a micrometre, so a told one is taken.
constexpr double kSlackMm = 1e-3;

double edge_in_hole(const codec::Family& host, double host_edge_mm, const NestedRequest& request) {
  const codec::Layout& layout = request.family->layout();
  const std::string where = fmt::format("{} {}", request.family->name(), request.id);
  const int hole = hole_cells(host.layout());
  if (hole == 0) {
    throw DoesNotFit(fmt::format("{} has no hole for another tag", host.name()), where,
                     "nest tags in a family whose layout leaves its middle out, like "
                     "tagCustom48h12");
  }
  const double hole_mm = host_edge_mm * hole / host.layout().width_at_border();
  const double largest = hole_mm / side_with_quiet_zone(layout, 1.0);
  if (!request.edge_mm) return largest;
  if (*request.edge_mm > largest + kSlackMm) {
    throw DoesNotFit(
        fmt::format("an edge of {} is too large for the hole of {}: with its quiet zone the tag "
                    "takes {}, and the hole has {}",
                    format_mm(*request.edge_mm), host.name(),
                    format_mm(side_with_quiet_zone(layout, *request.edge_mm)), format_mm(hole_mm)),
        where, fmt::format("leave the edge out, or take at most {}", format_mm(largest, "")));
  }
  return *request.edge_mm;
}

}  // namespace

int hole_cells(const codec::Layout& layout) {
  // A layout looks the same after a quarter turn, so the square grows ring by ring from the middle:
  // a whole ring where its top row is left out.
  const int width = layout.width();
  int hole = 0;
  for (int side = width % 2 == 0 ? 2 : 1; side <= width; side += 2) {
    const int first = (width - side) / 2;
    for (int x = first; x < first + side; ++x) {
      if (layout.cell(x, first) != codec::Cell::None) return hole;
    }
    hole = side;
  }
  return hole;
}

double side_with_quiet_zone(const codec::Layout& layout, double edge_mm) {
  return edge_mm * (layout.width() + 2 * quiet_cells(layout)) / layout.width_at_border();
}

std::vector<double> nested_edges(const codec::Family& host, double host_edge_mm,
                                 std::span<const NestedRequest> requests) {
  std::vector<double> edges;
  const codec::Family* outer = &host;
  double outer_edge_mm = host_edge_mm;
  for (const NestedRequest& request : requests) {
    if (request.edge_mm && !(std::isfinite(*request.edge_mm) && *request.edge_mm > 0)) {
      throw std::invalid_argument(
          fmt::format("an edge of {} cannot be; it is above 0", format_mm(*request.edge_mm)));
    }
    if (request.id >= request.family->size()) {
      throw std::invalid_argument(fmt::format("id {} is not in {}; its ids are 0-{}", request.id,
                                              request.family->name(), request.family->size() - 1));
    }
    edges.push_back(edge_in_hole(*outer, outer_edge_mm, request));
    outer = request.family.get();
    outer_edge_mm = edges.back();
  }
  return edges;
}

}  // namespace tagmint::draw
