#include "search/rotation/turn_code.h"

#include <algorithm>
#include <cassert>
#include <functional>

#include "search/rotation/kernel_finder.h"

namespace tagmint::codec {

void TurnCode::insert(Codeword word) {
  const Codeword rest = reduce(word);
  assert(rest != 0);
  for (Codeword& row : rows_) row = std::min(row, row ^ rest);
  rows_.insert(std::upper_bound(rows_.begin(), rows_.end(), rest, std::greater<>()), rest);
  basis_.push_back(word);
}

void TurnCode::extend(Codeword word) {
  assert(contains(turn_difference(word, bits_)));
  insert(word);
}

void TurnCode::adjoin(std::span<const Codeword> words) {
  for (const Codeword word : words) {
    // turn - 1 applied again and again ends in the code; from there upwards each is one step.
    std::vector<Codeword> steps;
    for (Codeword step = word; !contains(step); step = turn_difference(step, bits_)) {
      steps.push_back(step);
    }
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
      if (!contains(*step)) insert(*step);
    }
  }
}

TurnCode TurnCode::prefix(int dimension) const {
  TurnCode code(bits_);
  for (int i = 0; i < dimension; ++i) code.insert(basis_[static_cast<std::size_t>(i)]);
  return code;
}

std::vector<Codeword> one_step_extensions(const TurnCode& code, const TurnCode* inside) {
  std::vector<Codeword> candidates;
  if (inside != nullptr) {
    candidates.assign(inside->rows().begin(), inside->rows().end());
  } else {
    for (int bit = 0; bit < code.bits(); ++bit) candidates.push_back(Codeword{1} << bit);
  }
  KernelFinder closed;
  TurnCode taken = code;
  std::vector<Codeword> extensions;
  for (Codeword word : candidates) {
    if (!closed.add(word, code.reduce(turn_difference(word, code.bits())))) continue;
    if (taken.contains(word)) continue;
    taken.extend(word);
    extensions.push_back(code.reduce(word));
  }
  return extensions;
}

TurnCode random_subcode(const TurnCode& code, const TurnCode& keep, int dimension,
                        RandomChoice& random) {
  assert(keep.dimension() <= dimension && dimension <= code.dimension());
  TurnCode rest = code;
  while (rest.dimension() > dimension) {
    // A closed code of one dimension less holds keep and all turn differences: choose one of the
    // hyperplanes above these.
    TurnCode floor = keep;
    std::vector<Codeword> differences;
    for (const Codeword row : rest.rows()) {
      differences.push_back(turn_difference(row, code.bits()));
    }
    floor.adjoin(differences);
    TurnCode above = floor;
    std::vector<Codeword> free;  // span what is between floor and rest
    for (const Codeword row : rest.rows()) {
      if (above.contains(row)) continue;
      above.extend(row);
      free.push_back(row);
    }
    if (free.empty()) break;
    // The hyperplane where a random functional on `free` is 0: words with value 0, and sums of
    // words with value 1 and one such word.
    std::vector<bool> value(free.size(), false);
    while (std::find(value.begin(), value.end(), true) == value.end()) {
      for (std::size_t i = 0; i < free.size(); ++i) value[i] = random.below(2) == 1;
    }
    const auto pivot =
        static_cast<std::size_t>(std::find(value.begin(), value.end(), true) - value.begin());
    for (std::size_t i = 0; i < free.size(); ++i) {
      if (i != pivot) floor.extend(value[i] ? free[i] ^ free[pivot] : free[i]);
    }
    rest = floor;
  }
  return rest;
}

}  // namespace tagmint::codec
