#include "search/rotation/code_climb.h"

#include <algorithm>
#include <utility>

namespace tagmint::codec {

TurnCode climb(TurnCode code, const ClimbRules& rules, RandomChoice& random, WorkBudget& budget) {
  while (code.dimension() < rules.most_dimensions) {
    const std::vector<Codeword> extensions =
        far_extensions(code, rules.inside, rules.weights, budget);
    if (extensions.empty()) break;
    code.extend(random.of(extensions));
  }
  return code;
}

TurnCode climb_far(const TurnCode& floor, TurnCode start, const ClimbRules& rules,
                   RandomChoice& random, WorkBudget& budget) {
  // Each try costs something even where its codes are small.
  constexpr double kWordsPerTry = 1e5;
  TurnCode best = climb(std::move(start), rules, random, budget);
  const int most = std::min(rules.most_dimensions,
                            rules.inside != nullptr ? rules.inside->dimension() : kMaxBits);
  while (!budget.is_spent() && best.dimension() < most) {
    budget.spend(kWordsPerTry);
    const int room = best.dimension() - floor.dimension();
    if (room == 0) break;
    const int back = 1 + static_cast<int>(random.below(static_cast<std::size_t>(room)));
    TurnCode next =
        climb(random_subcode(best, floor, best.dimension() - back, random), rules, random, budget);
    if (next.dimension() >= best.dimension()) best = std::move(next);
  }
  return best;
}

}  // namespace tagmint::codec
