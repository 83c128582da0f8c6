#include "identify/evidence.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "tagmint/codec/family_stats.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::identify {

int nearest_miss_radius(const codec::Family& family) {
  constexpr double kLargestShare = 0.1;
  int radius = family.max_safe_errors();
  while (radius < family.bits() && Evidence::accept_rate(family, radius + 1) <= kLargestShare) {
    ++radius;
  }
  return radius;
}

bool is_plain(const codec::Layout& layout, codec::Codeword word) {
  constexpr int kOneIn = 8;
  const codec::TagCells cells = codec::tag_cells(layout, word);
  const auto is_data = [&](int x, int y) {
    return x < layout.width() && y < layout.width() && layout.cell(x, y) == codec::Cell::Data;
  };
  int neighbours = 0;
  int different = 0;
  for (const codec::CellPosition p : layout.data_cells()) {
    for (const codec::CellPosition q :
         {codec::CellPosition{p.x + 1, p.y}, codec::CellPosition{p.x, p.y + 1}}) {
      if (!is_data(q.x, q.y)) continue;
      ++neighbours;
      different += cells.at(p.x, p.y) != cells.at(q.x, q.y);
    }
  }
  return different * kOneIn < neighbours;
}

bool is_declared_plain(const codec::Family& family, codec::TagId id) {
  const std::span<const codec::Level> levels = family.levels();
  const auto level = std::find_if(levels.begin(), levels.end(),
                                  [&](const codec::Level& l) { return id < l.codes; });
  return id >= level->codes - level->plain;  // the last ones that the level adds
}

void Evidence::count(const codec::Family& family, const Doubt& doubt) {
  Compared& compared = compared_[&family];
  ++compared.words[doubt.unclear][static_cast<std::size_t>(doubt.oddity)];
  if (!compared.rates.empty()) return;
  for (int errors = 0; errors <= family.bits(); ++errors) {
    compared.rates.push_back(accept_rate(family, errors));
    if (compared.rates.back() >= 1) break;
  }
}

double Evidence::accept_rate(const codec::Family& family, int hamming) {
  return codec::false_accept_rate(family.size(), family.bits(), hamming);
}

double Evidence::expected_accidents(double accept_rate, const Doubt& doubt) const {
  double expected = 0;
  for (const auto& [family, compared] : compared_) {
    const auto above = std::upper_bound(compared.rates.begin(), compared.rates.end(), accept_rate);
    if (above == compared.rates.begin()) continue;
    std::size_t words = 0;
    for (std::size_t unclear = 0; unclear <= std::size_t{doubt.unclear}; ++unclear) {
      const auto& by_oddity = compared.words[unclear];
      words = std::accumulate(by_oddity.begin(), by_oddity.begin() + doubt.oddity + 1, words);
    }
    expected += static_cast<double>(words) * *std::prev(above);
  }
  return expected;
}

}  // namespace tagmint::identify
