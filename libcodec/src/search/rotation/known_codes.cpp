#include "search/rotation/known_codes.h"

#include <fmt/format.h>

#include <cassert>
#include <functional>
#include <numeric>

#include "search/rotation/kernel_finder.h"

namespace tagmint::codec {
namespace {

/// A word of a code over the points 0 .. bits-1 of some set, bit i = point i.
using PointWord = Codeword;

/// Which bit of a codeword each point has, so that the permutation `step` of the points, all of
/// whose cycles have length four, is a quarter turn: the points of a cycle stand at the same place
/// of the four blocks.
std::vector<int> order_points(int points, const std::function<int(int)>& step) {
  std::vector<int> shift_of(static_cast<std::size_t>(points), -1);
  int place = 0;
  for (int first = 0; first < points; ++first) {
    if (shift_of[static_cast<std::size_t>(first)] >= 0) continue;
    int point = first;
    for (int block = 0; block < 4; ++block, point = step(point)) {
      assert(shift_of[static_cast<std::size_t>(point)] < 0);
      shift_of[static_cast<std::size_t>(point)] = points - 1 - (block * (points / 4) + place);
    }
    assert(point == first);
    ++place;
  }
  return shift_of;
}

Codeword ordered(PointWord word, const std::vector<int>& shift_of) {
  Codeword result = 0;
  for (std::size_t point = 0; point < shift_of.size(); ++point) {
    result |= (word >> point & 1) << shift_of[point];
  }
  return result;
}

TurnCode spanned_by(const std::vector<PointWord>& words, const std::vector<int>& shift_of) {
  TurnCode code(static_cast<int>(shift_of.size()));
  std::vector<Codeword> basis;
  for (const PointWord word : words) basis.push_back(ordered(word, shift_of));
  code.adjoin(basis);
  return code;
}

/// The extended quadratic residue code of a prime p = 7 (mod 8): points 0 .. p-1 and infinity (p).
/// The words are the shifts of the set of residues, with a parity bit at infinity [MacWilliams and
/// Sloane, chapter 16]. It is invariant under z -> (az + b) / (cz + d) of determinant 1; of order
/// four without fixed points is z -> t - 1/z with t^2 = 2, for its matrix to the power of four is
/// -1, and t^2 - 4 = -2 is no square.
KnownChain quadratic_residue_chain(int p, int distance) {
  std::vector<bool> is_residue(static_cast<std::size_t>(p), false);
  int root_of_two = 0;
  std::vector<int> inverse(static_cast<std::size_t>(p), 0);
  for (int z = 1; z < p; ++z) {
    is_residue[static_cast<std::size_t>(z * z % p)] = true;
    if (z * z % p == 2) root_of_two = z;
    for (int y = 1; y < p; ++y) {
      if (z * y % p == 1) inverse[static_cast<std::size_t>(z)] = y;
    }
  }
  const auto turn = [&](int z) {
    if (z == p) return root_of_two;
    if (z == 0) return p;
    return (root_of_two + p - inverse[static_cast<std::size_t>(z)]) % p;
  };
  std::vector<PointWord> words;
  for (int shift = 0; shift < p; ++shift) {
    PointWord word = PointWord{1} << p;  // there are (p - 1) / 2 residues, an odd number
    for (int z = 0; z < p; ++z) {
      if (is_residue[static_cast<std::size_t>((z + p - shift) % p)]) word |= PointWord{1} << z;
    }
    words.push_back(word);
  }
  return {fmt::format("extended quadratic residue code of {}", p),
          p + 1,
          {{spanned_by(words, order_points(p + 1, turn)), distance}}};
}

/// The field of 2^degree elements as polynomials over GF(2), bit i = x^i.
class BinaryField {
 public:
  /// `modulus`: a primitive polynomial.
  BinaryField(int degree, unsigned modulus) : degree_(degree), modulus_(modulus) {}

  int size() const { return 1 << degree_; }
  unsigned product(unsigned a, unsigned b) const {
    unsigned result = 0;
    for (; b != 0; b >>= 1) {
      if (b & 1) result ^= a;
      a <<= 1;
      if (a >> degree_ & 1) a ^= modulus_;
    }
    return result;
  }
  unsigned power(unsigned a, int exponent) const {
    unsigned result = 1;
    for (int i = 0; i < exponent; ++i) result = product(result, a);
    return result;
  }

 private:
  int degree_;
  unsigned modulus_;
};

/// The extended BCH code of the field: words f with sum f(x) x^i = 0 for i = 0 .. designed - 2. By
/// the BCH bound its distance is at least `designed` + 1 for an odd `designed`.
std::vector<PointWord> extended_bch_words(const BinaryField& field, int designed) {
  // Conjugates give the same check, so odd powers and 0 suffice; each is `degree` bits.
  std::vector<PointWord> kernel;
  for (int point = 0; point < field.size(); ++point) kernel.push_back(PointWord{1} << point);
  for (int power = 0; power <= designed - 2; power += power == 0 ? 1 : 2) {
    KernelFinder finder;
    std::vector<PointWord> next;
    for (PointWord word : kernel) {
      unsigned check = 0;
      for (int x = 0; x < field.size(); ++x) {
        if (word >> x & 1) check ^= field.power(static_cast<unsigned>(x), power);
      }
      if (finder.add(word, check)) next.push_back(word);
    }
    kernel = std::move(next);
  }
  return kernel;
}

/// Extended BCH codes are invariant under x -> x^(2^i) + b. With the square root r of the field's
/// size, x -> x^r + b is of order four without fixed points where b^r != b: done twice it adds
/// b^r + b.
KnownChain bch_chain(int degree, unsigned modulus) {
  const BinaryField field(degree, modulus);
  const int root = 1 << (degree / 2);
  unsigned shift = 1;
  while (field.power(shift, root) == shift) ++shift;
  const std::vector<int> order = order_points(field.size(), [&](int x) {
    return static_cast<int>(field.power(static_cast<unsigned>(x), root) ^ shift);
  });
  KnownChain chain{fmt::format("extended BCH code of length {}", field.size()), field.size(), {}};
  for (int designed = field.size() / 2 - 1; designed >= 3; designed -= 2) {
    TurnCode code = spanned_by(extended_bch_words(field, designed), order);
    if (!chain.codes.empty() && chain.codes.back().code.dimension() == code.dimension()) continue;
    chain.codes.push_back({std::move(code), designed + 1});
  }
  return chain;
}

/// The words that are 0 outside the places `kept` of each block, with these places alone; places
/// are counted from the first cell of a block.
TurnCode shortened(const TurnCode& code, const std::vector<int>& kept, int places) {
  const int old_places = code.bits() / 4;
  const auto shift = [](int block, int place, int of) { return 4 * of - 1 - (block * of + place); };
  Codeword kept_bits = 0;
  for (int block = 0; block < 4; ++block) {
    for (const int place : kept) kept_bits |= Codeword{1} << shift(block, place, old_places);
  }
  KernelFinder finder;
  std::vector<Codeword> words;
  for (Codeword word : code.rows()) {
    if (!finder.add(word, word & ~kept_bits)) continue;
    Codeword moved = 0;
    for (int block = 0; block < 4; ++block) {
      for (std::size_t i = 0; i < kept.size(); ++i) {
        moved |= (word >> shift(block, kept[i], old_places) & 1)
                 << shift(block, static_cast<int>(i), places);
      }
    }
    words.push_back(moved);
  }
  TurnCode result(4 * places);
  result.adjoin(words);
  return result;
}

}  // namespace

std::vector<KnownChain> known_chains() {
  return {quadratic_residue_chain(7, 4),  quadratic_residue_chain(23, 8),
          quadratic_residue_chain(31, 8), quadratic_residue_chain(47, 12),
          bch_chain(4, 0b10011),          bch_chain(6, 0b1000011)};
}

KnownChain fit_chain(const KnownChain& chain, int bits, RandomChoice& random) {
  constexpr int kMostDimensions = 30;  // a larger one has more words than a family may
  const int places = bits / 4;
  std::vector<int> kept(static_cast<std::size_t>(chain.bits / 4));
  std::iota(kept.begin(), kept.end(), 0);
  random.shuffle(kept);
  if (static_cast<int>(kept.size()) > places) kept.resize(static_cast<std::size_t>(places));
  KnownChain fitted{chain.name, bits, {}};
  for (const KnownCode& known : chain.codes) {
    const TurnCode ring = shortened(known.code, kept, places);
    if (ring.dimension() == 0 || ring.dimension() > kMostDimensions) continue;
    std::vector<Codeword> words;
    for (const Codeword word : ring.basis()) words.push_back(word << (bits % 4));
    TurnCode code(bits);
    code.adjoin(words);
    fitted.codes.push_back({std::move(code), known.distance});
  }
  return fitted;
}

}  // namespace tagmint::codec
