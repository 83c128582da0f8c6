#include "search/published_bounds.h"

#include <algorithm>
#include <array>

namespace tagmint::codec {

namespace {

struct PublishedBound {
  int bits;
  int distance;
  unsigned words;
};

// clang-format off
constexpr std::array kPublished = {
    PublishedBound{18, 6, 673},   PublishedBound{19, 6, 1237},   PublishedBound{20, 6, 2279},
    PublishedBound{23, 6, 13674}, PublishedBound{19, 8, 135},    PublishedBound{20, 8, 256},
    PublishedBound{25, 8, 5421},  PublishedBound{26, 8, 9275},   PublishedBound{21, 10, 47},
    PublishedBound{22, 10, 84},   PublishedBound{24, 10, 268},   PublishedBound{25, 10, 466},
    PublishedBound{26, 10, 836},  PublishedBound{27, 10, 1585},  PublishedBound{28, 10, 2817},
    PublishedBound{25, 12, 55},   PublishedBound{26, 12, 96},
};
// clang-format on

}  // namespace

std::optional<WideCount> published_bound(int bits, int even_distance) {
  const auto* const found = std::ranges::find_if(kPublished, [&](const PublishedBound& bound) {
    return bound.bits == bits && bound.distance == even_distance;
  });
  if (found == kPublished.end()) return std::nullopt;
  return found->words;
}

}  // namespace tagmint::codec
