#pragma once

#include <vector>

namespace tagmint::codec {

/// Numbers of words, and products of two of them: at most 2^65 * 2^63.
__extension__ using WideCount = unsigned __int128;

/// Binomial coefficient; 0 unless 0 <= chosen <= from <= 65.
WideCount binomial(int from, int chosen);

/// Upper bounds of A(n, d, w), the number of words of n bits, w of them ones, at pairwise distance
/// d, for one d and all n up to some number of bits.
///   source  Johnson's recursions and his bound by counting ones by columns,
///           [Johnson1962]; [MacWilliamsSloane1977], chapter 17
class ConstantWeightBounds {
 public:
  ///   most_bits      0..65
  ///   even_distance  2, 4, ...
  ConstantWeightBounds(int most_bits, int even_distance);

  ///   bits    0..most_bits
  ///   weight  0..bits
  WideCount at(int bits, int weight) const { return bounds_[bits][weight]; }

 private:
  std::vector<std::vector<WideCount>> bounds_;
};

/// Upper bounds of A(n, d), the number of words of n bits at pairwise distance d, for even d: what
/// is known of odd distances follows from A(n - 1, d - 1) = A(n, d).
///   bits           1..65, at least the distance
///   even_distance  2, 4, ...
///   source         [MacWilliamsSloane1977], chapters 1, 2 and 17
///
/// The words without d - 1 of their bits still differ.
WideCount singleton_bound(int bits, int even_distance);
/// Balls of radius d/2 - 1 around the words without their last bit do not meet (Hamming).
WideCount sphere_packing_bound(int bits, int even_distance);
/// The words differ in few places on the average when 2 d >= n; 2^bits where that says nothing.
WideCount plotkin_bound(int bits, int even_distance);
/// Sphere packing that also counts the words just outside all balls. [Johnson1962]
///   weights  of the same distance, for at least bits - 1 bits
WideCount johnson_bound(int bits, int even_distance, const ConstantWeightBounds& weights);

}  // namespace tagmint::codec
