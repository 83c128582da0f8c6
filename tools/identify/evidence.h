#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "tagmint/codec/family.h"

namespace tagmint::identify {

/// How far the cells of a picture may differ from a tag for it to be named as the nearest miss:
/// more bits than are always corrected, but still a small share of all words.
///   returns   the larger of the safe radius and the largest number of errors with which at most a
///             tenth of all words passes for some tag
int nearest_miss_radius(const codec::Family& family);

/// Whether the data cells show little more than an even surface: fewer than an eighth of all
/// neighbours among them differ. No bundled family has such a tag; of random words hardly any is so
/// plain, but of what cameras see much is, so that the chances of random words say nothing about
/// it.
bool is_plain(const codec::Layout& layout, codec::Codeword word);

/// Whether the family declares the tag as one that fails its complexity rule (codec::Level::plain).
bool is_declared_plain(const codec::Family& family, codec::TagId id);

/// How much there is to say against a reading, whatever its word is near to.
struct Doubt {
  bool unclear = false;  ///< not Reading::clear
  int oddity = 0;        ///< what sets it apart from a plain print: mirrored, inverted, cut; 0..4
};

/// Keeps account of how often words were compared with families, and says how many matches that
/// alone would bring about, were all words random.
///
/// The account is kept by doubt: who believes a clear and plain print has not had to go on to
/// mirror images or to cells of uncertain colour, so these give no further chances of an accident.
class Evidence {
 public:
  /// A word was compared with all tags of `family` in four rotations.
  void count(const codec::Family& family, const Doubt& doubt);

  /// How likely a random word is as near to a tag of the family: codec::false_accept_rate().
  static double accept_rate(const codec::Family& family, int hamming);

  /// How many accidental matches are to be expected, in all comparisons of no more doubt, that are
  /// at least as convincing as one of that accept rate. Of each family those count that are as near
  /// as its own largest rate up to this one allows.
  double expected_accidents(double accept_rate, const Doubt& doubt) const;

 private:
  static constexpr int kOddities = 5;
  struct Compared {
    /// How many words, by Doubt::unclear and Doubt::oddity.
    std::array<std::array<std::size_t, kOddities>, 2> words{};
    std::vector<double> rates;  ///< by number of errors, ascending
  };
  std::map<const codec::Family*, Compared> compared_;
};

}  // namespace tagmint::identify
