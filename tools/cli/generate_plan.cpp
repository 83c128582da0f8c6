#include "cli/generate_plan.h"

#include <algorithm>

#include "tagmint/codec/layout_presets.h"

namespace tagmint::cli {

bool is_classic(const codec::Layout& layout) {
  return codec::layout_name(layout).starts_with("classic:");
}

codec::Order default_order(const codec::Layout& layout) {
  return {.kind =
              is_classic(layout) ? codec::Order::Kind::AprilTag2 : codec::Order::Kind::AprilTag3};
}

codec::Complexity default_complexity(const codec::Layout& layout) {
  constexpr double kEnergy = 0.3333;
  if (!is_classic(layout)) return {.rule = codec::ComplexityRule::Energy, .threshold = kEnergy};
  const int data_width = layout.width() - 4;
  const int rectangles = std::max(1, (5 * (data_width - 2) + 1) / 2);
  return {.rule = codec::ComplexityRule::Rectangles, .threshold = double(rectangles)};
}

std::vector<codec::Order> attempt_orders(const codec::Order& first, const codec::Layout& layout,
                                         int min_hamming, const codec::Complexity& complexity,
                                         int attempts) {
  const std::int64_t seed = codec::walk_seed(first, layout, min_hamming, complexity);
  std::vector<codec::Order> orders = {first};
  for (int i = 1; i < attempts; ++i) {
    orders.push_back({.kind = codec::Order::Kind::Seed, .seed = seed + i});
  }
  return orders;
}

}  // namespace tagmint::cli
