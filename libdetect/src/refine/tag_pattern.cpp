#include "refine/tag_pattern.h"

#include <algorithm>

namespace tagmint::detect {
namespace {

constexpr std::int8_t kHalfBright = 1;
constexpr std::int8_t kWhiteBright = 2;

}  // namespace

void TagPattern::begin(const codec::Family& family, codec::TagId id) {
  const codec::Layout& layout = family.layout();
  width_ = layout.width();
  border_begin_ = layout.border_offset();
  border_end_ = border_begin_ + layout.width_at_border();
  const auto padded_width = static_cast<std::size_t>(width_ + 2 * kPad);
  brightness_.assign(padded_width * padded_width, kHalfBright);
  known_.assign(static_cast<std::size_t>(width_) * width_, 0);
  const auto know = [&](int x, int y, bool white) {
    known_[index(x, y)] = 1;
    guess(x, y, white ? kWhiteBright : 0);
  };
  for (int y = 0; y < width_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const codec::Cell cell = layout.cell(x, y);
      if (cell == codec::Cell::White || cell == codec::Cell::Black) {
        know(x, y, cell == codec::Cell::White);
      }
    }
  }
  const codec::Codeword word = family.codeword(id);
  int bit = layout.bits();
  for (const codec::CellPosition p : layout.data_cells()) {
    know(p.x, p.y, ((word >> --bit) & 1) != 0);
  }
}

void TagPattern::finish(int edges) {
  edges_ = edges;
  extend_guesses();
  const int lines = width_ + 2;
  surroundings_.resize(static_cast<std::size_t>(lines) * lines);
  for (int y = -1; y <= width_; ++y) {
    for (int x = -1; x <= width_; ++x) {
      surroundings_[(y + 1) * lines + x + 1] = surroundings_at(x, y);
    }
  }
  flags_.resize(static_cast<std::size_t>(width_) * width_);
  for (int y = 0; y < width_; ++y) {
    for (int x = 0; x < width_; ++x) flags_[index(x, y)] = flags_of(x, y);
  }
}

/// Cells two and more away from the tag are like the nearest ones next to it.
void TagPattern::extend_guesses() {
  for (int y = -kPad; y < width_ + kPad; ++y) {
    for (int x = -kPad; x < width_ + kPad; ++x) {
      const int near_x = std::clamp(x, -1, width_);
      const int near_y = std::clamp(y, -1, width_);
      if (near_x != x || near_y != y) guess(x, y, brightness(near_x, near_y));
    }
  }
}

CellSurroundings TagPattern::surroundings_at(int first_x, int first_y) const {
  CellSurroundings around;
  const int side = edges_ + 1;
  const int step = width_ + 2 * kPad;
  for (int b = 0; b < side; ++b) {
    for (int a = 0; a < side; ++a) {
      const int x = std::min(first_x - 1 + a, width_ + kPad - 1);
      const int y = std::min(first_y - 1 + b, width_ + kPad - 1);
      const std::int8_t* c = brightness_.data() + padded(x, y);
      int mixed = c[0];
      if (a > 0) mixed -= c[-1];
      if (b > 0) mixed -= c[-step];
      if (a > 0 && b > 0) mixed += c[-step - 1];
      const int code = a + b * side;
      around.words[code / kCodesPerWord] |= (static_cast<std::uint32_t>(mixed) & 0xf)
                                            << (4 * (code % kCodesPerWord));
    }
  }
  return around;
}

std::int32_t TagPattern::flags_of(int x, int y) const {
  if (!is_known(x, y)) return 0;
  const int own = brightness(x, y);
  const auto unknown = [&](int i, int j) { return !is_known(i, j); };
  const auto changes = [&](int i, int j) { return is_known(i, j) && brightness(i, j) != own; };
  std::int32_t flags = kKnown;
  if (changes(x - 1, y)) flags |= kChangeLeft;
  if (changes(x + 1, y)) flags |= kChangeRight;
  if (changes(x, y - 1)) flags |= kChangeUp;
  if (changes(x, y + 1)) flags |= kChangeDown;
  for (int k = -1; k <= 1; ++k) {
    if (unknown(x - 1, y + k)) flags |= kUnknownLeft;
    if (unknown(x + 1, y + k)) flags |= kUnknownRight;
    if (unknown(x + k, y - 1)) flags |= kUnknownUp;
    if (unknown(x + k, y + 1)) flags |= kUnknownDown;
  }
  return flags;
}

}  // namespace tagmint::detect
