#include "refine/tag_pattern.h"

#include "tagmint/codec/tag_cells.h"

namespace tagmint::detect {
namespace {

constexpr int kUnknownBrightness = 1;

}  // namespace

int TagPattern::brightness(int x, int y) const {
  if (x < 0 || y < 0 || x >= width_ || y >= width_) return kUnknownBrightness;
  return brightness_[index(x, y)];
}

void TagPattern::assign(const codec::Family& family, codec::TagId id, int reach) {
  const codec::Layout& layout = family.layout();
  reach_ = reach;
  width_ = layout.width();
  border_begin_ = layout.border_offset();
  border_end_ = border_begin_ + layout.width_at_border();
  const auto cells = static_cast<std::size_t>(width_) * width_;
  brightness_.resize(cells);
  surroundings_.resize(cells);
  flags_.resize(cells);
  for (int y = 0; y < width_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const codec::Cell cell = layout.cell(x, y);
      brightness_[index(x, y)] = cell == codec::Cell::White   ? 2
                                 : cell == codec::Cell::Black ? 0
                                                              : kUnknownBrightness;
    }
  }
  const codec::Codeword word = family.codeword(id);
  int bit = layout.bits();
  for (const codec::CellPosition p : layout.data_cells()) {
    brightness_[index(p.x, p.y)] = ((word >> --bit) & 1) != 0 ? 2 : 0;
  }
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
  const int own = brightness(x, y);
  if (own == kUnknownBrightness) return 0;
  const auto unknown = [&](int i, int j) { return brightness(i, j) == kUnknownBrightness; };
  const auto changes = [&](int i, int j) { return !unknown(i, j) && brightness(i, j) != own; };
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
