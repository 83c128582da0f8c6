#include "tagmint/codec/search/size_bound.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "search/best_word_bound.h"
#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

namespace {

/// The smallest double that is not less.
double rounded_up(WideCount count) {
  const auto nearest = static_cast<double>(count);
  return static_cast<WideCount>(nearest) >= count
             ? nearest
             : std::nextafter(nearest, std::numeric_limits<double>::infinity());
}

}  // namespace

SizeBound upper_bound_of_tags(int bits, int distance) {
  if (bits < 1 || bits > kMaxBits) {
    throw std::invalid_argument(
        fmt::format("words of {} bits; 1 to {} are allowed", bits, kMaxBits));
  }
  if (distance < 1) {
    throw std::invalid_argument(
        fmt::format("Hamming distance {}; at least 1 is allowed", distance));
  }
  const WordBound words = best_word_bound(bits, distance);
  // A tag's four turns are four different words.
  return {rounded_up(words.words / 4), words.source};
}

}  // namespace tagmint::codec
