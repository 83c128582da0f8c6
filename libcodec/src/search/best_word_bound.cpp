#include "search/best_word_bound.h"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string_view>

#include "search/linear_programming_bound.h"
#include "search/published_bounds.h"

namespace tagmint::codec {

namespace {

/// A bound, and where it comes from: `source` at `bits` bits, and that many times twice as many.
struct Candidate {
  WideCount words;
  std::string_view source;
  int bits;
  int doublings = 0;
};

void keep_smaller(Candidate& best, const Candidate& other) {
  if (other.words < best.words) best = other;
}

/// The best bound that speaks of words of just that length. Linear programming comes last, because
/// it takes its time, and only where Singleton's and Plotkin's bounds are not reached by codes.
Candidate direct_bound(int bits, int distance, const ConstantWeightBounds& weights, bool program) {
  Candidate best = {singleton_bound(bits, distance), "Singleton", bits};
  keep_smaller(best, {plotkin_bound(bits, distance), "Plotkin", bits});
  keep_smaller(best, {sphere_packing_bound(bits, distance), "sphere packing", bits});
  keep_smaller(best, {johnson_bound(bits, distance, weights), "Johnson", bits});
  if (const auto published = published_bound(bits, distance)) {
    keep_smaller(best, {*published, "published semidefinite programming", bits});
  } else if (program && distance > 2 && 2 * distance < bits) {
    keep_smaller(best,
                 {linear_programming_bound(bits, distance, weights), "linear programming", bits});
  }
  return best;
}

}  // namespace

WordBound best_word_bound(int bits, int distance) {
  // A(n, d) = A(n + 1, d + 1) for odd d: add a parity bit, or leave out a bit.
  const int parity_bits = distance % 2;
  const int even_distance = distance + parity_bits;
  const int all_bits = bits + parity_bits;
  if (even_distance > all_bits) return {1, "one word"};

  // A(n, d) <= 2 A(n - 1, d): half of the words at least agree in a bit, which can be left out.
  const ConstantWeightBounds weights(all_bits, even_distance);
  Candidate best = {1, "one word", even_distance - 1};
  for (int length = even_distance; length <= all_bits; ++length) {
    best.words *= 2;
    ++best.doublings;
    // Twice the linear programming bound of one bit less is smaller at times, by a few words; of
    // fewer bits hardly ever.
    const bool program = length >= all_bits - 1;
    const Candidate direct = direct_bound(length, even_distance, weights, program);
    if (direct.words <= best.words) best = direct;
  }
  if (best.doublings == 0) return {best.words, std::string(best.source)};
  return {best.words, fmt::format("{} times {} at {} bits", std::uint64_t{1} << best.doublings,
                                  best.source, best.bits - parity_bits)};
}

}  // namespace tagmint::codec
