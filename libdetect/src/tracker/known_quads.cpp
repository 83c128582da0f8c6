#include "tracker/known_quads.h"

#include <algorithm>
#include <cmath>

namespace tagmint::detect {
namespace {

/// The same quad, found twice, has its middle within this share of its side...
constexpr double kMiddleShare = 0.08;
/// ...and this share of its area.
constexpr double kAreaShare = 0.2;

}  // namespace

KnownQuads::Entry KnownQuads::entry_of(const Quad& quad) {
  Point sum;
  for (const Point corner : quad.corners) sum = sum + corner;
  return {0.25 * sum.y, 0.25 * sum.x, std::abs(signed_area(quad.corners)), quad.reversed_border};
}

void KnownQuads::assign(std::span<const Quad> quads, double scale) {
  entries_.clear();
  for (const Quad& quad : quads) {
    Entry entry = entry_of(quad);
    entry.y /= scale;
    entry.x /= scale;
    entry.area /= scale * scale;
    entries_.push_back(entry);
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.y < b.y; });
}

bool KnownQuads::holds(const Quad& quad) const {
  const Entry wanted = entry_of(quad);
  const double near = kMiddleShare * std::sqrt(wanted.area) + 1;
  const auto first = std::lower_bound(entries_.begin(), entries_.end(), wanted.y - near,
                                      [](const Entry& entry, double y) { return entry.y < y; });
  for (auto entry = first; entry != entries_.end() && entry->y <= wanted.y + near; ++entry) {
    if (std::abs(entry->x - wanted.x) <= near && entry->reversed_border == wanted.reversed_border &&
        std::abs(entry->area - wanted.area) <= kAreaShare * std::max(entry->area, wanted.area)) {
      return true;
    }
  }
  return false;
}

}  // namespace tagmint::detect
