#include "cli/reading_curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tagmint/codec/layout_presets.h"

namespace tagmint::cli {
namespace {

using codec::parse_layout;

TEST(ReadingCurve, HoldsWhatWasMeasured) {
  EXPECT_DOUBLE_EQ(cell_reading(parse_layout("classic:10"), 1.2).border_found, 0.929);
  EXPECT_DOUBLE_EQ(cell_reading(parse_layout("classic:10"), 1.2).wrong_cells, 0.0521);
  EXPECT_DOUBLE_EQ(cell_reading(parse_layout("standard:9"), 1.4).wrong_cells, 0.0219);
  EXPECT_DOUBLE_EQ(cell_reading(parse_layout("circle:11"), 1.4).wrong_cells, 0.0327);
}

TEST(ReadingCurve, IsLinearBetweenTheMeasuredSizes) {
  const CellReading reading = cell_reading(parse_layout("classic:8"), 1.25);
  EXPECT_NEAR(reading.border_found, (0.238 + 0.571) / 2, 1e-12);
  EXPECT_NEAR(reading.wrong_cells, (0.0219 + 0.0089) / 2, 1e-12);
}

TEST(ReadingCurve, GoesByTheRingsOutsideTheBorderSquare) {
  const auto wrong = [](const char* layout) {
    return cell_reading(parse_layout(layout), 1.5).wrong_cells;
  };
  EXPECT_EQ(wrong("classic:12"), wrong("classic:8"));
  EXPECT_EQ(wrong("standard:10"), wrong("circle:9"));
  EXPECT_LT(wrong("classic:8"), wrong("standard:10"));
  EXPECT_LT(wrong("standard:10"), wrong("circle:11"));
}

TEST(ReadingCurve, LargerCellsAreNeverReadWorse) {
  for (const char* name : {"classic:8", "classic:9", "classic:10", "standard:9", "circle:11"}) {
    const codec::Layout layout = parse_layout(name);
    CellReading before = cell_reading(layout, 0);
    for (double cell_px = 0.01; cell_px < 4; cell_px += 0.01) {
      const CellReading reading = cell_reading(layout, cell_px);
      EXPECT_GE(reading.border_found, before.border_found) << name << ' ' << cell_px;
      EXPECT_LE(reading.wrong_cells, before.wrong_cells) << name << ' ' << cell_px;
      before = reading;
    }
    EXPECT_EQ(before.border_found, 1);
    EXPECT_EQ(before.wrong_cells, 0);
  }
}

TEST(ReadingCurve, ShareFoundIsTheBinomialOne) {
  const codec::Layout layout = parse_layout("classic:8");  // 16 cells
  const double right = 1 - 0.0219;
  EXPECT_NEAR(share_found(layout, 1.2, 0), 0.238 * std::pow(right, 16), 1e-12);
  EXPECT_NEAR(share_found(layout, 1.2, 1),
              0.238 * (std::pow(right, 16) + 16 * 0.0219 * std::pow(right, 15)), 1e-12);
  EXPECT_NEAR(share_found(layout, 1.2, 16), 0.238, 1e-12);
  EXPECT_EQ(share_found(layout, 5, 0), 1);
  EXPECT_EQ(share_found(layout, 0.5, 3), 0);
}

TEST(ReadingCurve, TheCellForAShareIsWhereTheShareIsReached) {
  for (const char* name : {"classic:8", "classic:9", "classic:10", "standard:9", "circle:11"}) {
    const codec::Layout layout = parse_layout(name);
    for (const int errors : {0, 2, 5}) {
      const double cell_px = cell_px_for_share(layout, errors, 0.95);
      EXPECT_GE(share_found(layout, cell_px, errors), 0.95);
      EXPECT_LT(share_found(layout, cell_px - 0.001, errors), 0.95);
    }
  }
}

}  // namespace
}  // namespace tagmint::cli
