#pragma once

#include "search/rotation/extension_sieve.h"
#include "search/rotation/random_choice.h"
#include "search/rotation/turn_code.h"

namespace tagmint::codec {

/// Where a climb may go.
struct ClimbRules {
  WeightRule weights = {};
  /// The code must stay inside this one, where it is given.
  const TurnCode* inside = nullptr;
  /// Largest dimension.
  int most_dimensions = kMaxBits;
};

/// Grows `code`, which obeys the rules, by random one-step extensions until there is none left.
TurnCode climb(TurnCode code, const ClimbRules& rules, RandomChoice& random, WorkBudget& budget);

/// Looks for a large code between `floor` and what the rules allow: climbs from `start`, then again
/// and again steps back to a random subcode that still holds `floor` and climbs anew; a code that
/// is not smaller replaces the one before (iterated local search). Ends with the budget.
///   floor, start   obey the rules, floor inside start
TurnCode climb_far(const TurnCode& floor, TurnCode start, const ClimbRules& rules,
                   RandomChoice& random, WorkBudget& budget);

}  // namespace tagmint::codec
