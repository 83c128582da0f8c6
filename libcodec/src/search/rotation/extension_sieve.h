#pragma once

#include <cstdint>
#include <stop_token>
#include <utility>
#include <vector>

#include "search/rotation/turn_code.h"

namespace tagmint::codec {

/// What the weights of a linear code must be.
struct WeightRule {
  int at_least = 1;  ///< weight of every word but 0
  int divisor = 1;   ///< which divides all weights
};

/// How long a search may go on: counted in words that it compares, so that its end does not depend
/// on the clock, and until it is asked to stop.
struct Effort {
  double words = 0;
  std::stop_token stop = {};
};

/// What is left of an effort.
class WorkBudget {
 public:
  explicit WorkBudget(Effort effort) : effort_(std::move(effort)) {}
  void spend(double words) { effort_.words -= words; }
  bool is_spent() const { return effort_.words <= 0 || effort_.stop.stop_requested(); }

 private:
  Effort effort_;
};

/// All ways to grow a closed code whose words obey `rule` by one dimension so that they still do:
/// one word of each class modulo `code`, the least, in no particular order.
///   inside   a closed code that contains `code` and that the grown one must not leave; null = any
///   code     obeys the rule
///   cost     at most 2^(dimension + bits / 4 + 1) comparisons, and far fewer: most classes hold a
///            word that is too light among the first that are looked at. They are told to `budget`,
///            which does not end the search.
std::vector<Codeword> far_extensions(const TurnCode& code, const TurnCode* inside,
                                     const WeightRule& rule, WorkBudget& budget);

}  // namespace tagmint::codec
