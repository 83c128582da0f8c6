// Written over the ring GF(2)[R] with R^4 = 1, R a quarter turn, and S = R + 1, so that S^4 = 0 and
// S^2 w = w ^ half turn(w). A free code with generators w_1 .. w_g has the words
//
//     s_1 w_1 + ... + s_g w_g + k     s_i in {0, 1, R, S}, k in the kernel S^2 C
//
// since every element of the ring is one of these four and a multiple of S^2. To flip two cells
// that a half turn exchanges is to add a multiple of S^2 to an entry of a generator, which changes
// neither the kernel nor a word without a share s_i of that generator. So the words without a share
// of w_i, w_(i+1), .. can be proven far before these are chosen, and of those with a share of w_i
// and none of the later ones, the ones with s_i = 1 and s_i = S are enough: R turns 1 into R.

#include "search/rotation/free_code.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "kernels/hamming_kernels.h"
#include "search/rotation/least_weight.h"

namespace tagmint::codec {
namespace {

/// Most flips of a generator that are searched.
constexpr std::size_t kMostFlips = std::size_t{1} << 12;

/// All sums of `words` and of those of `sums`.
void add_sums(std::vector<Codeword>& sums, std::span<const Codeword> words) {
  for (const Codeword word : words) {
    const std::size_t half = sums.size();
    for (std::size_t i = 0; i < half; ++i) sums.push_back(sums[i] ^ word);
  }
}

/// The shape of the generators: the first is 1 in the first block at the first place, 0 in the
/// other blocks there and at the first places of the other generators; the second likewise.
class GeneratorShape {
 public:
  GeneratorShape(int bits, int generators) : bits_(bits), generators_(generators) {}

  int bits() const { return bits_; }
  int generators() const { return generators_; }

  /// Places where all generators are arbitrary.
  int free_places() const { return bits_ / 4 - generators_; }

  Codeword own_cell(int generator) const { return cell(0, generator); }

  /// The four cells of a free place, by block.
  std::array<Codeword, 4> free_cells(int place) const {
    std::array<Codeword, 4> cells{};
    for (int block = 0; block < 4; ++block) {
      cells[static_cast<std::size_t>(block)] = cell(block, generators_ + place);
    }
    return cells;
  }

 private:
  Codeword cell(int block, int place) const {
    return Codeword{1} << (bits_ - 1 - block * (bits_ / 4) - place);
  }

  int bits_;
  int generators_;
};

/// Random generators, of even weight where the distance is even.
std::vector<Codeword> random_generators(const GeneratorShape& shape, int distance,
                                        RandomChoice& random) {
  std::vector<Codeword> words;
  for (int generator = 0; generator < shape.generators(); ++generator) {
    Codeword word = shape.own_cell(generator);
    for (int place = 0; place < shape.free_places(); ++place) {
      for (const Codeword cell : shape.free_cells(place)) word ^= random.below(2) == 1 ? cell : 0;
    }
    const bool wrong_parity = distance % 2 == 0 && std::popcount(word) % 2 == 1;
    words.push_back(wrong_parity ? word ^ shape.free_cells(0).front() : word);
  }
  return words;
}

/// A basis of the kernel.
std::vector<Codeword> kernel_basis(std::span<const Codeword> generators, int bits) {
  std::vector<Codeword> basis;
  for (const Codeword word : generators) {
    const Codeword sum = word ^ rotate(word, bits, 2);
    basis.push_back(sum);
    basis.push_back(rotate_quarter(sum, bits));
  }
  return basis;
}

/// What a half turn of one place makes of a word.
Codeword half_turned(Codeword word, const std::array<Codeword, 4>& cells) {
  Codeword all = 0;
  Codeword turned = 0;
  for (std::size_t block = 0; block < 4; ++block) {
    all |= cells[block];
    if ((word & cells[block]) != 0) turned |= cells[(block + 2) % 4];
  }
  return (word & ~all) | turned;
}

/// Whether a flipped generator stands for those that give the same codes up to half turns of
/// places: of the first generator each place may be turned by itself. A half turn of all free
/// places is one of the generator and of its own place, and may be made of each of them.
bool stands_for_its_turns(Codeword word, int generator, const GeneratorShape& shape) {
  Codeword all = word;
  for (int place = 0; place < shape.free_places(); ++place) {
    const auto cells = shape.free_cells(place);
    all = half_turned(all, cells);
    if (generator == 0 && half_turned(word, cells) < word) return false;
  }
  return word <= all;
}

/// The generator with its flips: all that matter, or kMostFlips at random.
std::vector<Codeword> flipped(Codeword word, int generator, const GeneratorShape& shape,
                              RandomChoice& random) {
  std::vector<Codeword> flips;
  for (int place = 0; place < shape.free_places(); ++place) {
    const auto cells = shape.free_cells(place);
    flips.push_back(cells[0] | cells[2]);
    flips.push_back(cells[1] | cells[3]);
  }
  std::vector<Codeword> words = {word};
  if (std::size_t{1} << flips.size() <= kMostFlips) {
    add_sums(words, flips);
    std::erase_if(words,
                  [&](Codeword one) { return !stands_for_its_turns(one, generator, shape); });
    return words;
  }
  while (words.size() < kMostFlips) {
    for (const Codeword flip : flips) word ^= random.below(2) == 1 ? flip : 0;
    words.push_back(word);
  }
  return words;
}

/// The search through all flips of some generators.
class LiftSearch {
 public:
  /// `kernel` has all its words, and they are heavy enough.
  LiftSearch(int bits, int distance, std::vector<Codeword> kernel, WorkBudget& budget)
      : bits_(bits), distance_(distance), kernel_(std::move(kernel)), budget_(budget) {}

  /// One choice of each generator that keeps the distance; nothing where there is none or the
  /// budget ends.
  std::optional<std::vector<Codeword>> run(std::vector<std::vector<Codeword>> choices) {
    for (std::vector<Codeword>& words : choices) keep_far(words, kernel_);
    chosen_.clear();
    if (!choose(kernel_, choices)) return std::nullopt;
    return chosen_;
  }

 private:
  /// Chooses among the first of `choices`, which are far from `sums`, the sums of the kernel and
  /// the generators chosen before; then among the rest.
  bool choose(const std::vector<Codeword>& sums, std::span<const std::vector<Codeword>> choices) {
    if (choices.empty()) return true;
    for (const Codeword word : choices.front()) {
      if (budget_.is_spent()) return false;
      chosen_.push_back(word);
      if (choose_after(word, sums, choices.subspan(1))) return true;
      chosen_.pop_back();
    }
    return false;
  }

  bool choose_after(Codeword word, const std::vector<Codeword>& sums,
                    std::span<const std::vector<Codeword>> choices) {
    if (choices.empty()) return true;
    std::vector<Codeword> grown = sums;
    add_sums(grown, std::array{word, rotate_quarter(word, bits_)});
    const auto added = std::span<const Codeword>(grown).subspan(sums.size());
    std::vector<std::vector<Codeword>> left;
    for (const std::vector<Codeword>& words : choices) {
      left.push_back(words);
      keep_far(left.back(), added);
      if (left.back().empty()) return false;
    }
    return choose(grown, left);
  }

  /// Leaves those that keep the distance in sums with `others`, alone and with their turn.
  void keep_far(std::vector<Codeword>& words, std::span<const Codeword> others) {
    std::erase_if(words, [&](Codeword word) {
      return !is_far(word, others) || !is_far(turn_difference(word, bits_), others);
    });
  }

  bool is_far(Codeword word, std::span<const Codeword> others) {
    const std::size_t first = first_within(others, word, distance_ - 1);
    budget_.spend(static_cast<double>(first + 1));
    return first == others.size();
  }

  int bits_;
  int distance_;
  std::vector<Codeword> kernel_;
  WorkBudget& budget_;
  std::vector<Codeword> chosen_;
};

}  // namespace

std::optional<TurnCode> find_free_code(int bits, int generators, int distance, RandomChoice& random,
                                       WorkBudget& budget) {
  assert(bits % 4 == 0 && bits / 4 > generators);
  assert(generators >= 2 && generators <= kMostFreeGenerators);
  const GeneratorShape shape(bits, generators);
  while (!budget.is_spent()) {
    const std::vector<Codeword> words = random_generators(shape, distance, random);
    const std::vector<Codeword> basis = kernel_basis(words, bits);
    budget.spend(std::ldexp(1.0, static_cast<int>(basis.size())));
    if (least_weight(basis) < distance) continue;
    std::vector<std::vector<Codeword>> choices;
    for (int generator = 0; generator < generators; ++generator) {
      const Codeword word = words[static_cast<std::size_t>(generator)];
      choices.push_back(flipped(word, generator, shape, random));
    }
    std::vector<Codeword> kernel = {0};
    add_sums(kernel, basis);
    LiftSearch search(bits, distance, std::move(kernel), budget);
    if (const auto found = search.run(std::move(choices))) {
      TurnCode code(bits);
      code.adjoin(*found);
      return code;
    }
  }
  return std::nullopt;
}

}  // namespace tagmint::codec
