#include "search/rotation/free_code.h"

#include <array>
#include <cassert>
#include <cmath>

#include "kernels/count_within.h"
#include "search/rotation/least_weight.h"

namespace tagmint::codec {
namespace {

/// The code that some generators and their turns span.
class FreeCode {
 public:
  FreeCode(int bits, int generators, int distance)
      : bits_(bits), places_(bits / 4), distance_(distance), words_(generators) {}

  /// Draws generators until the words that a half turn keeps are heavy enough; false where the
  /// budget ends first.
  bool draw(RandomChoice& random, WorkBudget& budget) {
    while (!budget.is_spent()) {
      for (std::size_t own = 0; own < words_.size(); ++own) words_[own] = random_word(own, random);
      std::vector<Codeword> kept;
      for (const Codeword word : words_) {
        const Codeword sum = word ^ rotate(word, bits_, 2);
        kept.push_back(sum);
        kept.push_back(rotate_quarter(sum, bits_));
      }
      budget.spend(std::ldexp(1.0, static_cast<int>(kept.size())));
      if (least_weight(kept) >= distance_) return true;
    }
    return false;
  }

  /// A flip that keeps these words: of which generator, and which bits.
  struct Flip {
    std::size_t generator = 0;
    Codeword bits = 0;
  };
  Flip random_flip(RandomChoice& random) const {
    const std::size_t generators = words_.size();
    const std::size_t generator = random.below(generators);
    const std::size_t place =
        generators + random.below(static_cast<std::size_t>(places_) - generators);
    const Codeword one = bit(random.below(2), place);
    return {generator, one | rotate(one, bits_, 2)};
  }
  void flip(const Flip& flip) { words_[flip.generator] ^= flip.bits; }

  /// How many words are lighter than the distance; some number above `enough` where they are more
  /// than that. Words of one orbit are counted once where that is easy, and then as four.
  double light_words(double enough, WorkBudget& budget) {
    sum_up_others();
    // One of the turns of a word with a share of the first generator has one of these shares.
    constexpr std::array<int, 5> kShares = {0b0001, 0b0011, 0b0101, 0b0111, 0b1111};
    double light = 0;
    for (const int share : kShares) {
      Codeword sum = 0;
      for (int turn = 0; turn < 4; ++turn) {
        if (share >> turn & 1) sum ^= rotate(words_.front(), bits_, turn);
      }
      budget.spend(static_cast<double>(others_.size()));
      light += 4.0 * static_cast<double>(count_within(others_, sum, distance_ - 1));
      if (light > enough) return light;
    }
    // The word 0 is light and does not count.
    return light + static_cast<double>(count_within(others_, 0, distance_ - 1)) - 1;
  }

  TurnCode code() const {
    TurnCode code(bits_);
    code.adjoin(words_);
    return code;
  }

 private:
  Codeword bit(std::size_t block, std::size_t place) const {
    return Codeword{1} << (bits_ - 1 - static_cast<int>(block) * places_ - static_cast<int>(place));
  }

  /// 1 in the first block at the place of its own, 0 at the other generators' places, and of even
  /// weight where the distance is even.
  Codeword random_word(std::size_t own, RandomChoice& random) const {
    Codeword word = bit(0, own);
    for (std::size_t place = words_.size(); place < static_cast<std::size_t>(places_); ++place) {
      for (std::size_t block = 0; block < 4; ++block) {
        if (random.below(2) == 1) word ^= bit(block, place);
      }
    }
    const bool wrong_parity = distance_ % 2 == 0 && std::popcount(word) % 2 == 1;
    return wrong_parity ? word ^ bit(0, static_cast<std::size_t>(places_) - 1) : word;
  }

  /// All sums of the turns of all generators but the first.
  void sum_up_others() {
    others_.assign(1, 0);
    for (std::size_t i = 1; i < words_.size(); ++i) {
      for (int turn = 0; turn < 4; ++turn) {
        const Codeword word = rotate(words_[i], bits_, turn);
        const std::size_t half = others_.size();
        for (std::size_t j = 0; j < half; ++j) others_.push_back(others_[j] ^ word);
      }
    }
  }

  int bits_;
  int places_;
  int distance_;
  std::vector<Codeword> words_;
  std::vector<Codeword> others_;
};

/// By how much more light words a step may leave, at random: exponential with the mean
/// `temperature`.
double random_rise(double temperature, RandomChoice& random) {
  constexpr std::size_t kSteps = std::size_t{1} << 52;
  const double share =
      (static_cast<double>(random.below(kSteps)) + 1.0) / static_cast<double>(kSteps);
  return -temperature * std::log(share);
}

}  // namespace

std::optional<TurnCode> anneal_free_code(int bits, int generators, int distance,
                                         RandomChoice& random, WorkBudget& budget) {
  assert(bits % 4 == 0 && bits / 4 > generators);
  assert(generators >= 2 && generators <= kMostFreeGenerators);
  // Measured on 36 bits at distance 10: many short searches find more than few long ones, and
  // temperatures of half an orbit of four words serve best.
  constexpr int kSteps = 10000;
  constexpr double kTemperature = 2.0;
  FreeCode code(bits, generators, distance);
  while (code.draw(random, budget)) {
    double light = code.light_words(INFINITY, budget);
    for (int step = 0; step < kSteps && light > 0 && !budget.is_spent(); ++step) {
      const FreeCode::Flip flip = code.random_flip(random);
      const double most = light + random_rise(kTemperature, random);
      code.flip(flip);
      const double after = code.light_words(most, budget);
      if (after <= most) {
        light = after;
      } else {
        code.flip(flip);
      }
    }
    if (light == 0) return code.code();
  }
  return std::nullopt;
}

}  // namespace tagmint::codec
