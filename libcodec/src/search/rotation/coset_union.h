#pragma once

#include <vector>

#include "search/rotation/extension_sieve.h"
#include "search/rotation/random_choice.h"
#include "search/rotation/turn_code.h"

namespace tagmint::codec {

/// Most classes of words modulo a kernel that unite_cosets() looks at.
inline constexpr int kMostClassBits = 22;

/// A large set of words, closed under quarter turns and `distance` apart, that is a union of cosets
/// of `kernel`: an independent set in the graph whose nodes are the turn orbits of cosets that keep
/// the distance by themselves, and whose edges join orbits that are too near to each other; found
/// by local search (free nodes are added, else one node is exchanged for another, else a random one
/// is forced in). No word is fixed by a half turn.
///   kernel    its words but 0 have at least the weight `distance`; bits - dimension <=
///             kMostClassBits
///   returns   one word of each tag; empty where there is none
///   cost      O(nodes) for each exchange; told to `budget`, whose end ends the search
std::vector<Codeword> unite_cosets(const TurnCode& kernel, int distance, RandomChoice& random,
                                   WorkBudget& budget);

}  // namespace tagmint::codec
