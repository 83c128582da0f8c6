#include "refine/tag_pattern.h"

#include <algorithm>

namespace tagmint::detect {
namespace {

constexpr std::int8_t kHalfBright = 1;
constexpr std::int8_t kWhite = 2;

}  // namespace

int TagPattern::brightness(int x, int y) const {
  x = std::clamp(x, -1, width_);
  y = std::clamp(y, -1, width_);
  return brightness_[(y + 1) * (width_ + 2) + x + 1];
}

void TagPattern::guess(int x, int y, int brightness) {
  brightness_[(y + 1) * (width_ + 2) + x + 1] = static_cast<std::int8_t>(brightness);
}

void TagPattern::begin(const codec::Family& family, codec::TagId id) {
  const codec::Layout& layout = family.layout();
  width_ = layout.width();
  border_begin_ = layout.border_offset();
  border_end_ = border_begin_ + layout.width_at_border();
  const auto cells = static_cast<std::size_t>(width_) * width_;
  brightness_.assign(static_cast<std::size_t>(width_ + 2) * (width_ + 2), kHalfBright);
  known_.assign(cells, 0);
  surroundings_.resize(cells);
  flags_.resize(cells);
  const auto know = [&](int x, int y, bool white) {
    known_[index(x, y)] = 1;
    guess(x, y, white ? kWhite : 0);
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
  for (const codec::CellPosition p : layout.data_cells()) know(p.x, p.y, ((word >> --bit) & 1) != 0);
}

void TagPattern::finish(int reach) {
  reach_ = reach;
  for (int y = 0; y < width_; ++y) {
    for (int x = 0; x < width_; ++x) {
      surroundings_[index(x, y)] = surroundings_of(x, y);
      flags_[index(x, y)] = flags_of(x, y);
    }
  }
}

CellSurroundings TagPattern::surroundings_of(int x, int y) const {
  const int side = 2 * reach_ + 1;
  const auto c = [&](int a, int b) { return brightness(x - reach_ + a, y - reach_ + b); };
  CellSurroundings around;
  for (int b = 0; b < side; ++b) {
    for (int a = 0; a < side; ++a) {
      int mixed = c(a, b);
      if (a > 0) mixed -= c(a - 1, b);
      if (b > 0) mixed -= c(a, b - 1);
      if (a > 0 && b > 0) mixed += c(a - 1, b - 1);
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
