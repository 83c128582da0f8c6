#include "search/rotation/extension_sieve.h"

#include <algorithm>
#include <bit>

#include "kernels/hamming_kernels.h"
#include "search/rotation/gray_walk.h"

namespace tagmint::codec {
namespace {

/// Whether the divisor divides the weights of all words of the grown code when it does so in
/// `code`: the weight of a sum is that of its terms less twice their common bits, so for 4 the new
/// word must have an even number of bits in common with each word of a basis.
bool keeps_divisor(const TurnCode& code, Codeword word, int divisor) {
  if (std::popcount(word) % divisor != 0) return false;
  return divisor < 4 || std::all_of(code.rows().begin(), code.rows().end(), [&](Codeword row) {
           return std::popcount(row & word) % 2 == 0;
         });
}

/// All sums of `words` but 0 that keep the divisor.
std::vector<Codeword> candidate_classes(const TurnCode& code, std::span<const Codeword> words,
                                        int divisor) {
  std::vector<Codeword> all;
  Codeword sum = 0;
  for (std::uint64_t step = 1; step < std::uint64_t{1} << words.size(); ++step) {
    sum ^= words[static_cast<std::size_t>(std::countr_zero(step))];
    if (keeps_divisor(code, sum, divisor)) all.push_back(sum);
  }
  return all;
}

}  // namespace

std::vector<Codeword> far_extensions(const TurnCode& code, const TurnCode* inside,
                                     const WeightRule& rule, WorkBudget& budget) {
  constexpr std::size_t kFirstStretch = 64;
  constexpr std::size_t kLongestStretch = std::size_t{1} << 16;
  std::vector<Codeword> candidates =
      candidate_classes(code, one_step_extensions(code, inside), rule.divisor);
  GrayWalk walk(code.rows());
  std::vector<Codeword> words;
  for (std::size_t stretch = kFirstStretch; !candidates.empty();
       stretch = std::min(2 * stretch, kLongestStretch)) {
    walk.next(stretch, words);
    if (words.empty()) break;
    // Where most classes fail early, this counts too much, in the same way for every search.
    budget.spend(static_cast<double>(candidates.size()) * static_cast<double>(words.size()));
    std::erase_if(candidates, [&](Codeword candidate) {
      return first_within(words, candidate, rule.at_least - 1) < words.size();
    });
  }
  return candidates;
}

}  // namespace tagmint::codec
