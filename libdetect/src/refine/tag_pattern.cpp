#include "refine/tag_pattern.h"

#include <algorithm>

namespace tagmint::detect {
namespace {

constexpr std::int8_t kHalfBright = 1;
constexpr std::int8_t kWhiteBright = 2;

}  // namespace

void TagPattern::begin(const codec::Family& family, codec::TagId id, bool inverted, bool mirrored) {
  const codec::Layout& layout = family.layout();
  width_ = layout.width();
  border_begin_ = layout.border_offset();
  border_end_ = border_begin_ + layout.width_at_border();
  const auto padded_width = static_cast<std::size_t>(width_ + 2 * kPad);
  brightness_.assign(padded_width * padded_width, kHalfBright);
  known_.assign(padded_width * padded_width, 0);
  const auto know = [&](int x, int y, bool white) {
    if (mirrored) x = width_ - 1 - x;
    known_[padded(x, y)] = 1;
    guess(x, y, white != inverted ? kWhiteBright : 0);
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

bool TagPattern::plain_rim() const {
  const auto like_first = [&](int x, int y) {
    return is_known(x, y) && brightness(x, y) == brightness(0, 0);
  };
  for (int i = 0; i < width_; ++i) {
    if (!like_first(i, 0) || !like_first(0, i) || !like_first(i, width_ - 1) ||
        !like_first(width_ - 1, i)) {
      return false;
    }
  }
  return true;
}

void TagPattern::finish(int edges) {
  edges_ = edges;
  extend_guesses();
  take_differences();
  if (edges == kWideCells) fill_surroundings<kWideCells>();
  if (edges == kMiddlingCells) fill_surroundings<kMiddlingCells>();
  if (edges == kSmallCells) fill_surroundings<kSmallCells>();
  flags_.resize(static_cast<std::size_t>(width_) * width_);
  for (int y = 0; y < width_; ++y) {
    for (int x = 0; x < width_; ++x) flags_[index(x, y)] = flags_of(x, y);
  }
}

/// Cells two and more away from the tag are like the nearest ones next to it.
void TagPattern::extend_guesses() {
  const int step = width_ + 2 * kPad;
  for (int y = -1; y <= width_; ++y) {
    std::int8_t* row = brightness_.data() + padded(-kPad, y);
    std::fill(row, row + kPad - 1, row[kPad - 1]);
    std::fill(row + step - kPad + 1, row + step, row[step - kPad]);
  }
  for (int y = 0; y < kPad - 1; ++y) {
    std::copy_n(brightness_.data() + padded(-kPad, -1), step, brightness_.data() + y * step);
    std::copy_n(brightness_.data() + padded(-kPad, width_), step,
                brightness_.data() + (step - 1 - y) * step);
  }
}

void TagPattern::take_differences() {
  const int step = width_ + 2 * kPad;
  const std::size_t size = brightness_.size();
  for (std::vector<std::uint32_t>* codes : {&code_, &code_x_, &code_y_, &code_xy_}) {
    codes->assign(size, 0);
  }
  const auto low = [](int value) { return static_cast<std::uint32_t>(value) & 0xf; };
  const std::int8_t* c = brightness_.data();
  for (std::size_t i = static_cast<std::size_t>(step) + 1; i < size; ++i) {
    code_[i] = low(c[i]);
    code_x_[i] = low(c[i] - c[i - 1]);
    code_y_[i] = low(c[i] - c[i - step]);
    code_xy_[i] = low(c[i] - c[i - 1] - c[i - step] + c[i - step - 1]);
  }
}

template <int kEdges>
void TagPattern::fill_surroundings() {
  constexpr int kSide = kEdges + 1;
  const int step = width_ + 2 * kPad;
  // Lines on the far side of the tag have no pixels; their surroundings may end with the grid.
  const int last_begin = static_cast<int>(code_.size()) - kEdges * (step + 1) - 1;
  surroundings_.resize(static_cast<std::size_t>(width_ + 2) * (width_ + 2));
  CellSurroundings* around = surroundings_.data();
  for (int y = -1; y <= width_; ++y) {
    for (int x = -1; x <= width_; ++x, ++around) {
      const int begin = std::min(padded(x - 1, y - 1), last_begin);
      *around = {};
      for (int code = 0; code < kSide * kSide; ++code) {
        const int a = code % kSide;
        const int b = code / kSide;
        const std::vector<std::uint32_t>& from =
            a == 0 ? (b == 0 ? code_ : code_y_) : (b == 0 ? code_x_ : code_xy_);
        around->words[code / kCodesPerWord] |= from[begin + a + b * step]
                                               << (4 * (code % kCodesPerWord));
      }
    }
  }
}

std::int32_t TagPattern::flags_of(int x, int y) const {
  const int step = width_ + 2 * kPad;
  const std::int8_t* known = known_.data() + padded(x, y);
  const std::int8_t* bright = brightness_.data() + padded(x, y);
  if (known[0] == 0) return 0;
  std::int32_t flags = kKnown;
  const auto change = [&](int beside, std::int32_t flag) {
    if (known[beside] != 0 && bright[beside] != bright[0]) flags |= flag;
  };
  change(-1, kChangeLeft);
  change(1, kChangeRight);
  change(-step, kChangeUp);
  change(step, kChangeDown);
  const auto unknown = [&](int beside, int along, std::int32_t flag) {
    if ((known[beside - along] & known[beside] & known[beside + along]) == 0) flags |= flag;
  };
  unknown(-1, step, kUnknownLeft);
  unknown(1, step, kUnknownRight);
  unknown(-step, 1, kUnknownUp);
  unknown(step, 1, kUnknownDown);
  return flags;
}

}  // namespace tagmint::detect
