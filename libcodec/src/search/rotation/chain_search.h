#pragma once

#include <span>
#include <string>
#include <vector>

#include "search/rotation/extension_sieve.h"
#include "search/rotation/known_codes.h"

namespace tagmint::codec {

/// Closed codes, each inside the next, with falling distances.
struct CodeChain {
  struct Level {
    TurnCode code;
    int distance = 0;  ///< asked for; the code's own may be larger
  };
  std::vector<Level> levels;
  std::string construction;  ///< in words, for people
};

/// How many tags the code has: (words - words that a half turn maps to themselves) / 4.
double tags_of(const TurnCode& code);

/// How good a chain is: the sum of log2(tags) over its levels, so that twice as many tags count
/// alike in each level, but three times as much in the whole family, the last one. Levels without a
/// tag, or without one more than the level before, count nothing.
double value_of(const CodeChain& chain);

/// One attempt at a chain with a code for each of `distances`, which fall. From the largest
/// distance to the smallest, each level's code is climbed to from the one before (code_climb.h),
/// first with weights divisible by four, then by two, then any. With `known`, fitted to `bits`, a
/// level begins with the largest of its codes that is far enough and holds the level before, and
/// stays inside the smallest one that is not.
///   vary     give way at random: leave out some of the known codes, and of a level's code up to
///            two dimensions; a smaller code may leave room for larger ones around it
///   effort   for each level
CodeChain search_chain(int bits, std::span<const int> distances, const KnownChain* known, bool vary,
                       const Effort& effort, RandomChoice& random);

/// The other way round: the whole family's code is searched first, then inside it one for the next
/// larger distance, and so on up to the largest. With `known`, the whole code begins with the
/// largest of its codes that is far enough.
CodeChain search_chain_upward(int bits, std::span<const int> distances, const KnownChain* known,
                              const Effort& effort, RandomChoice& random);

/// Levels inside a code that is there: for each of `distances`, which fall and are larger than
/// `whole`'s, as search_chain_upward(). Distances whose code has no tag are left out.
CodeChain search_inside(const CodeChain::Level& whole, std::span<const int> distances,
                        const Effort& effort, RandomChoice& random);

}  // namespace tagmint::codec
