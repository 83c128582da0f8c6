#include "tagmint/codec/search/order.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <string>
#include <vector>

#include "search/java_random.h"
#include "search/odd_inverse.h"
#include "tagmint/codec/suggest.h"

namespace tagmint::codec {
namespace {

constexpr std::string_view kSeedPrefix = "seed:";

static_assert(inverse_of_odd(Walk::kStep) * Walk::kStep == 1);

std::int64_t parse_seed(std::string_view digits) {
  std::int64_t seed = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), seed);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    throw std::invalid_argument(fmt::format(
        "order 'seed:{}' needs a whole number of at most 64 bits, like seed:42", digits));
  }
  return seed;
}

}  // namespace

Order parse_order(std::string_view text) {
  if (text == "apriltag2") return {Order::Kind::AprilTag2};
  if (text == "apriltag3") return {Order::Kind::AprilTag3};
  if (text.substr(0, kSeedPrefix.size()) == kSeedPrefix) {
    return {Order::Kind::Seed, parse_seed(text.substr(kSeedPrefix.size()))};
  }
  const std::vector<std::string> names = {"apriltag2", "apriltag3", "seed"};
  const std::string hint = did_you_mean(text.substr(0, text.find(':')), names);
  throw std::invalid_argument(
      fmt::format("unknown order '{}'; {}{}orders are apriltag2, apriltag3, seed:N", text, hint,
                  hint.empty() ? "" : " "));
}

std::string to_string(const Order& order) {
  switch (order.kind) {
    case Order::Kind::AprilTag2:
      return "apriltag2";
    case Order::Kind::AprilTag3:
      return "apriltag3";
    case Order::Kind::Seed:
      break;
  }
  return fmt::format("{}{}", kSeedPrefix, order.seed);
}

std::int64_t walk_seed(const Order& order, const Layout& layout, int min_hamming,
                       const Complexity& complexity) {
  if (order.kind == Order::Kind::Seed) return order.seed;
  std::int64_t c = 0;
  if (order.kind == Order::Kind::AprilTag3) {
    c = layout.width() * layout.width() / 8;
  } else if (complexity.rule == ComplexityRule::Rectangles) {
    c = static_cast<std::int64_t>(std::clamp(complexity.threshold, 0.0, double{kMaxBits}));
  }
  return layout.bits() * std::int64_t{10000} + min_hamming * std::int64_t{100} + c;
}

Walk::Walk(const Layout& layout, const Order& order, std::int64_t seed)
    : bits_(layout.bits()),
      start_(static_cast<Codeword>(JavaRandom(seed).next_long()) & low_mask(layout.bits())) {
  if (order.kind == Order::Kind::AprilTag2) {
    to_visited_ = reading_order(layout);
    to_codeword_ = to_visited_->inverse();
  }
}

std::uint64_t Walk::position_of(Codeword word) const {
  constexpr std::uint64_t kStepInverse = inverse_of_odd(kStep);
  const std::uint64_t position = ((to_visited(word) - start_) * kStepInverse) & low_mask(bits_);
  if (position != 0 || bits_ == kMaxBits) return position;
  return std::uint64_t{1} << bits_;  // the walk ends where it started
}

}  // namespace tagmint::codec
