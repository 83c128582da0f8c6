#include "colour_changes.h"

#include <bit>

namespace tagmint::codec {
namespace {

constexpr int kNoBit = -1;

bool is_fixed(Cell cell) { return cell == Cell::Black || cell == Cell::White; }

/// Marks one more neighbour of the bit: the first mask that does not hold it yet.
void add_neighbour(std::array<Codeword, 4>& masks, int shift) {
  for (Codeword& mask : masks) {
    if ((mask >> shift) & 1) continue;
    mask |= Codeword{1} << shift;
    return;
  }
}

}  // namespace

ColourChanges::ColourChanges(const Layout& layout) {
  const int width = layout.width();
  std::vector<int> shift_at(static_cast<std::size_t>(width) * width, kNoBit);
  int shift = layout.bits();
  for (const CellPosition p : layout.data_cells()) shift_at[p.y * width + p.x] = --shift;

  const auto add_pair = [&](CellPosition a, CellPosition b) {
    const Cell cell_a = layout.cell(a.x, a.y);
    const Cell cell_b = layout.cell(b.x, b.y);
    const int shift_a = shift_at[a.y * width + a.x];
    const int shift_b = shift_at[b.y * width + b.x];
    if (cell_a == Cell::Data && cell_b == Cell::Data) {
      data_pairs_.emplace_back(shift_a, shift_b);
    } else if (cell_a == Cell::Data && is_fixed(cell_b)) {
      add_neighbour(cell_b == Cell::Black ? beside_black_ : beside_white_, shift_a);
    } else if (is_fixed(cell_a) && cell_b == Cell::Data) {
      add_neighbour(cell_a == Cell::Black ? beside_black_ : beside_white_, shift_b);
    } else if (is_fixed(cell_a) && is_fixed(cell_b)) {
      fixed_changes_ += cell_a != cell_b;
    }
  };
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) {
      cells_ += layout.cell(x, y) != Cell::None;
      if (x + 1 < width) add_pair({x, y}, {x + 1, y});
      if (y + 1 < width) add_pair({x, y}, {x, y + 1});
    }
  }
}

int ColourChanges::count(Codeword word) const {
  int changes = fixed_changes_;
  for (const auto& [a, b] : data_pairs_)
    changes += static_cast<int>(((word >> a) ^ (word >> b)) & 1);
  for (const Codeword mask : beside_black_) changes += std::popcount(word & mask);
  for (const Codeword mask : beside_white_) changes += std::popcount(~word & mask);
  return changes;
}

ChangeBits ColourChanges::change_bits(Codeword word) const {
  ChangeBits bits{};
  std::size_t place = 0;
  const auto add = [&](Codeword change) {
    bits[place / 64] |= (change & 1) << (place % 64);
    ++place;
  };
  for (const auto& [a, b] : data_pairs_) add((word >> a) ^ (word >> b));
  const auto add_fixed = [&](Codeword mask, Codeword changed) {
    for (Codeword rest = mask; rest != 0; rest &= rest - 1) add(changed >> std::countr_zero(rest));
  };
  for (const Codeword mask : beside_black_) add_fixed(mask, word);
  for (const Codeword mask : beside_white_) add_fixed(mask, ~word);
  return bits;
}

}  // namespace tagmint::codec
