#pragma once

#include <optional>

#include "search/rotation/extension_sieve.h"
#include "search/rotation/random_choice.h"
#include "search/rotation/turn_code.h"

namespace tagmint::codec {

/// Most generators of find_free_code(): 2^20 words.
inline constexpr int kMostFreeGenerators = 5;

/// A closed code with the minimum weight `distance` that `generators` words and their turns span
/// without dependence: dimension 4 * generators, a free module in the language of quasi-cyclic
/// codes. One-step climbing (code_climb.h) rarely ends in one.
///
/// By lifting. Let H be a half turn. The words w ^ H(w) of such a code are a code of half the
/// dimension, its kernel. It does not change when in one generator two cells that a half turn
/// exchanges are flipped together, so a kernel belongs to all the codes that such flips lead to,
/// and there are few kernels up to moving and turning places. So random generators are drawn until
/// their kernel is heavy enough, and then all their flips are searched: a flipped generator must
/// keep the distance together with the kernel and with those chosen before it, and each choice
/// filters what is left for the generators after it. Where there are very many flips, some at
/// random are searched. Nothing where the effort ends first.
///   bits        of the ring: divisible by 4, more than 4 * generators
///   generators  2 to kMostFreeGenerators
std::optional<TurnCode> find_free_code(int bits, int generators, int distance, RandomChoice& random,
                                       WorkBudget& budget);

}  // namespace tagmint::codec
