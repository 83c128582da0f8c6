#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// Code turns in *cells*: those whose low bits agree lie side by side. A cell is named by these low
/// bits, turned so that the lowest ones come first:
///
///     word   [ upper | middle | lowest ]          cell   [ lowest | middle ]
///                       `--- fine bits              coarse bits --'
///
/// so all cells that agree in the `coarse bits` lowest bits are neighbours too: one *coarse cell*.
class TurnIndex {
 public:
  /// 0 <= coarse_bits <= fine_bits <= min(bits, 31); at most 2^32 - 1 turns.
  ///   cost   O(turns + 2^fine_bits) time; 8 bytes a turn, 4 more where at most 32 upper bits
  ///          remain, 4 a cell
  TurnIndex(int bits, int fine_bits, int coarse_bits, std::span<const Codeword> turns);

  std::uint32_t cell_of(Codeword word) const {
    const Codeword fine = word & low_mask(fine_bits_);
    const Codeword lowest = word & low_mask(coarse_bits_);
    return static_cast<std::uint32_t>(lowest << (fine_bits_ - coarse_bits_) | fine >> coarse_bits_);
  }
  std::uint32_t coarse_cell_of(Codeword word) const {
    return static_cast<std::uint32_t>(word & low_mask(coarse_bits_));
  }

  std::span<const Codeword> turns() const { return words_; }
  /// The turns of a coarse cell.
  std::span<const Codeword> coarse_cell(std::uint32_t cell) const {
    const int shift = fine_bits_ - coarse_bits_;
    const std::size_t begin = starts_[std::size_t{cell} << shift];
    return turns().subspan(begin, starts_[(std::size_t{cell} + 1) << shift] - begin);
  }
  /// Turns of cell c are starts()[c] .. starts()[c + 1] - 1.
  const std::uint32_t* starts() const { return starts_.data(); }
  /// The upper bits of all turns, by cell, padded for the kernels; bits - fine_bits <= 32.
  const std::uint32_t* uppers() const { return uppers_.data(); }

 private:
  int fine_bits_;
  int coarse_bits_;
  std::vector<std::uint32_t> starts_;
  std::vector<Codeword> words_;
  std::vector<std::uint32_t> uppers_;
};

/// All words of `bits` bits with exactly `weight` ones, ascending; 0 <= weight, bits <= 31.
std::vector<std::uint32_t> words_of_weight(int bits, int weight);

}  // namespace tagmint::codec
