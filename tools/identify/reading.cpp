#include "identify/reading.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace tagmint::identify {
namespace {

using codec::Cell;
using codec::CellPosition;
using codec::Layout;
using detect::Point;

/// Gray levels between black and white below which there is no tag.
constexpr double kLeastContrast = 6;
/// As the detector has it (docs/pipeline.md): cells of one colour that scatter by more than this
/// share of the contrast are no cells.
constexpr double kMostScatter = 0.35;
/// Share of the fixed cells that may have the wrong colour: dirt, a reflection.
constexpr double kMostWrongFixedCells = 0.1;
/// Share of a ring that must be in the picture for its colour to be known.
constexpr double kLeastRingShare = 0.5;
/// Weight of the Laplacian that raises a cell against its neighbours, as the detector's default.
constexpr double kSharpening = 0.25;

/// What separates black from white at each place of the tag.
struct Threshold {
  double cx = 0;
  double cy = 0;
  double c0 = 0;
  double contrast = 0;  ///< in the middle: white less black

  double at(Point p) const { return cx * p.x + cy * p.y + c0; }
};

std::vector<CellPosition> ring_of(const Frame& frame, int ring) {
  const int last = frame.width - 1 - ring;
  if (ring < 0 || ring > last) return {};
  if (ring == last) return {{ring, ring}};
  std::vector<CellPosition> cells;
  for (int i = ring; i < last; ++i) {
    cells.push_back({i, ring});
    cells.push_back({last, i});
    cells.push_back({last - i + ring, last});
    cells.push_back({ring, last - i + ring});
  }
  return cells;
}

/// The cells of `ring` that are in the picture; none where too few are.
std::vector<CellPosition> visible_ring(const CellGrid& grid, int ring) {
  std::vector<CellPosition> cells = ring_of(grid.frame(), ring);
  const std::size_t all = cells.size();
  std::erase_if(cells, [&](CellPosition p) { return !grid.at(p.x, p.y); });
  if (static_cast<double>(cells.size()) < kLeastRingShare * static_cast<double>(all)) return {};
  return cells;
}

/// gray(x, y) = [0] x + [1] y + [2] nearest to the cells, and the sum of their squared distances.
struct Plane {
  Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();
  double squared_residuals = 0;
};

Plane fit_plane(const CellGrid& grid, const std::vector<CellPosition>& cells) {
  Eigen::MatrixX3d places(cells.size(), 3);
  Eigen::VectorXd grays(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Point p = cell_middle(grid.frame(), cells[i].x, cells[i].y);
    const auto row = static_cast<Eigen::Index>(i);
    places.row(row) << p.x, p.y, 1;
    grays(row) = *grid.at(cells[i].x, cells[i].y);
  }
  Plane plane;
  plane.coefficients = places.colPivHouseholderQr().solve(grays);
  plane.squared_residuals = (places * plane.coefficients - grays).squaredNorm();
  return plane;
}

/// Half-way between the planes of the two rings at the border square; nothing where they are alike
/// or uneven.
std::optional<Threshold> between_rings(const CellGrid& grid,
                                       const std::vector<CellPosition>& inside,
                                       const std::vector<CellPosition>& outside) {
  const Plane inner = fit_plane(grid, inside);
  const Plane outer = fit_plane(grid, outside);
  const double contrast = std::abs(outer.coefficients[2] - inner.coefficients[2]);
  const double scatter = std::sqrt((inner.squared_residuals + outer.squared_residuals) /
                                   static_cast<double>(inside.size() + outside.size()));
  if (contrast < kLeastContrast || scatter > kMostScatter * contrast) return std::nullopt;
  const Eigen::Vector3d middle = (inner.coefficients + outer.coefficients) / 2;
  return Threshold{middle[0], middle[1], middle[2], contrast};
}

/// The split of all cells of the tag into two gray levels that scatter least about their means
/// [Otsu1979]; nothing where they are no two levels.
std::optional<Threshold> between_levels(const CellGrid& grid, const Layout& layout) {
  std::vector<double> grays;
  for (int y = 0; y < layout.width(); ++y) {
    for (int x = 0; x < layout.width(); ++x) {
      if (layout.cell(x, y) != Cell::None && grid.at(x, y)) grays.push_back(*grid.at(x, y));
    }
  }
  std::sort(grays.begin(), grays.end());
  double total = 0, total_of_squares = 0;
  for (const double gray : grays) {
    total += gray;
    total_of_squares += gray * gray;
  }
  const auto count = static_cast<double>(grays.size());
  double least = total_of_squares + 1;
  Threshold best;
  double sum = 0;
  for (std::size_t dark = 1; dark < grays.size(); ++dark) {
    sum += grays[dark - 1];
    const auto n = static_cast<double>(dark);
    const double dark_mean = sum / n;
    const double light_mean = (total - sum) / (count - n);
    const double scatter =
        total_of_squares - n * dark_mean * dark_mean - (count - n) * light_mean * light_mean;
    if (scatter >= least) continue;
    least = scatter;
    best = {0, 0, (dark_mean + light_mean) / 2, light_mean - dark_mean};
  }
  const double scatter = std::sqrt(std::max(0.0, least) / std::max(1.0, count));
  if (best.contrast < kLeastContrast || scatter > kMostScatter * best.contrast) return std::nullopt;
  return best;
}

/// Of each cell in the picture, how much lighter than the threshold it is.
class Excess {
 public:
  Excess(const CellGrid& grid, const Layout& layout, const Threshold& threshold)
      : grid_(grid), layout_(layout), threshold_(threshold) {}

  /// Raised against the neighbours, to undo blur across the edges of cells.
  double sharpened(CellPosition p) const {
    constexpr std::array<CellPosition, 4> kSteps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const double value = *of(p);
    double laplacian = 0;
    for (const CellPosition step : kSteps) {
      const auto neighbour = of({p.x + step.x, p.y + step.y});
      if (neighbour) laplacian += value - *neighbour;
    }
    return value + kSharpening * laplacian;
  }

 private:
  std::optional<double> of(CellPosition p) const {
    const int width = layout_.width();
    if (p.x < 0 || p.y < 0 || p.x >= width || p.y >= width) return std::nullopt;
    if (layout_.cell(p.x, p.y) == Cell::None || !grid_.at(p.x, p.y)) return std::nullopt;
    return *grid_.at(p.x, p.y) - threshold_.at(cell_middle(grid_.frame(), p.x, p.y));
  }

  const CellGrid& grid_;
  const Layout& layout_;
  const Threshold& threshold_;
};

/// The fixed cells in the picture, and how many of them have the colour of the layout.
struct FixedCells {
  int seen = 0;
  int right = 0;
  bool all_seen = true;
};

FixedCells compare_fixed_cells(const CellGrid& grid, const Layout& layout, const Excess& excess) {
  FixedCells fixed;
  for (int y = 0; y < layout.width(); ++y) {
    for (int x = 0; x < layout.width(); ++x) {
      const Cell cell = layout.cell(x, y);
      if (cell != Cell::Black && cell != Cell::White) continue;
      if (!grid.at(x, y)) {
        fixed.all_seen = false;
        continue;
      }
      ++fixed.seen;
      fixed.right += (excess.sharpened({x, y}) > 0) == (cell == Cell::White);
    }
  }
  return fixed;
}

codec::Codeword word_on(const Layout& layout, const Excess& excess) {
  codec::Codeword word = 0;
  for (const CellPosition p : layout.data_cells()) {
    word = word << 1 | static_cast<codec::Codeword>(excess.sharpened(p) > 0);
  }
  return word;
}

/// Reading::clear.
bool is_clear(const Layout& layout, const Excess& excess, double contrast, int wrong_fixed_cells) {
  constexpr int kOneIn = 20;
  const auto vague =
      std::count_if(layout.data_cells().begin(), layout.data_cells().end(), [&](CellPosition p) {
        return std::abs(excess.sharpened(p)) <
               contrast / 4;  // the middle is contrast / 2 from both
      });
  return (vague + wrong_fixed_cells) * kOneIn <= layout.bits();
}

bool all_data_seen(const CellGrid& grid, const Layout& layout) {
  return std::all_of(layout.data_cells().begin(), layout.data_cells().end(),
                     [&](CellPosition p) { return grid.at(p.x, p.y).has_value(); });
}

}  // namespace

std::vector<Reading> read_tag(const CellGrid& grid, const Layout& layout) {
  if (!all_data_seen(grid, layout)) return {};
  const auto inside = visible_ring(grid, layout.border_offset());
  const auto outside = visible_ring(grid, layout.border_offset() - 1);
  if (inside.empty() && !outside.empty()) return {};
  const std::optional<Threshold> threshold = inside.empty() || outside.empty()
                                                 ? between_levels(grid, layout)
                                                 : between_rings(grid, inside, outside);
  if (!threshold) return {};
  const Excess excess(grid, layout, *threshold);
  const FixedCells fixed = compare_fixed_cells(grid, layout, excess);
  const codec::Codeword word = word_on(layout, excess);
  const BorderPart border = fixed.all_seen   ? BorderPart::Whole
                            : inside.empty() ? BorderPart::None
                                             : BorderPart::Cut;
  std::vector<Reading> readings;
  for (const bool inverted : {false, true}) {
    const int wrong = inverted ? fixed.right : fixed.seen - fixed.right;
    if (wrong > kMostWrongFixedCells * fixed.seen) continue;
    const bool clear = is_clear(layout, excess, threshold->contrast, wrong);
    // Without any border, only cells that are certainly cells tell of a tag.
    if (border == BorderPart::None && !clear) continue;
    const codec::Codeword mask = codec::low_mask(layout.bits());
    readings.push_back({inverted ? ~word & mask : word, inverted, border, clear});
  }
  return readings;
}

}  // namespace tagmint::identify
