#pragma once

#include <optional>

#include "search/rotation/extension_sieve.h"
#include "search/rotation/random_choice.h"
#include "search/rotation/turn_code.h"

namespace tagmint::codec {

/// Most generators of anneal_free_code(): 2^16 words.
inline constexpr int kMostFreeGenerators = 4;

/// A closed code with the minimum weight `distance` that `generators` words and their turns span
/// without dependence: dimension 4 * generators, a free module in the language of quasi-cyclic
/// codes. One-step climbing (code_climb.h) rarely ends in one.
///
/// Simulated annealing. Each generator is 1 at a place of its own and arbitrary at all others. To
/// begin with, random ones are drawn until the words that a half turn keeps, which are the sums of
/// w ^ half turn(w), are heavy enough. These do not change when in one place of a generator two
/// cells that a half turn exchanges are flipped together; such flips are the steps, and the number
/// of light words is what they lower. Nothing where the effort ends first.
///   bits        of the ring: divisible by 4, more than 4 * generators
///   generators  2 to kMostFreeGenerators
std::optional<TurnCode> anneal_free_code(int bits, int generators, int distance,
                                         RandomChoice& random, WorkBudget& budget);

}  // namespace tagmint::codec
