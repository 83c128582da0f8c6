// Each kernel of the tracker gives with every instruction set what its plain reference gives.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernels/edge_kernels.h"
#include "kernels/halve_kernels.h"
#include "kernels/outline_kernels.h"
#include "kernels/start_kernels.h"
#include "kernels/tile_kernels.h"
#include "support/fixed_random.h"
#include "support/instruction_sets.h"

namespace tagmint::detect {
namespace {

using testing::FixedRandom;
using testing::with_every_instruction_set;

/// A whole number in [0, end).
std::uint64_t below(FixedRandom& random, std::uint64_t end) { return random.bits() % end; }

using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<std::uint64_t>;

/// Widths around the lengths of vectors.
const std::vector<int> kWidths = {1, 2, 3, 4, 5, 7, 15, 16, 17, 31, 33, 63, 64, 65, 97, 128, 131};

/// Random gray values; some pictures use few levels, so that equal ones and flat tiles occur.
Bytes random_bytes(std::size_t size, FixedRandom& random) {
  Bytes bytes(size);
  const int levels = below(random, 3) == 0 ? 3 : 256;
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(below(random, static_cast<std::uint64_t>(levels)) *
                                     static_cast<std::uint64_t>(255 / (levels - 1)));
  }
  return bytes;
}

/// Four rows that end where their memory ends.
struct FourRows {
  std::vector<Bytes> memory;
  PixelRows rows;

  FourRows(int width, FixedRandom& random) {
    for (std::size_t i = 0; i < kTile; ++i) {
      memory.push_back(random_bytes(static_cast<std::size_t>(width), random));
      rows[i] = memory[i].data();
    }
  }
};

/// Extrema of a row of tiles with their padding.
struct Extrema {
  Bytes low, high;

  explicit Extrema(int width) {
    low.resize(static_cast<std::size_t>(width) + 3 * kTileRowPadding);
    high = low;
  }
  std::uint8_t* low_at() { return low.data() + kTileRowPadding; }
  std::uint8_t* high_at() { return high.data() + kTileRowPadding; }
  TileRow row() const { return {low.data() + kTileRowPadding, high.data() + kTileRowPadding}; }
};

/// The values that tile_extrema() promises.
Bytes promised(const Bytes& row, int width) {
  return {row.begin() + kTileRowPadding - kTile,
          row.begin() + kTileRowPadding + (width + kTile - 1) / kTile * kTile + kTile};
}

TEST(TileKernels, ExtremaAreThoseOfThePlainLoop) {
  with_every_instruction_set([] {
    FixedRandom random(1);
    for (const int width : kWidths) {
      const FourRows pixels(width, random);
      Extrema fast(width), plain(width);
      tile_extrema(pixels.rows, width, fast.low_at(), fast.high_at());
      scalar::tile_extrema(pixels.rows, width, plain.low_at(), plain.high_at());
      ASSERT_EQ(promised(fast.low, width), promised(plain.low, width)) << width;
      ASSERT_EQ(promised(fast.high, width), promised(plain.high, width)) << width;
    }
  });
}

TEST(TileKernels, BitsAreThoseOfThePlainLoop) {
  with_every_instruction_set([] {
    FixedRandom random(2);
    for (const int width : kWidths) {
      for (const ContrastRule rule : {ContrastRule{5, 255}, {0, 255}, {30, 90}, {200, 0}}) {
        const FourRows pixels(width, random);
        std::vector<Extrema> tiles(3, Extrema(width));
        for (Extrema& row : tiles) {
          const FourRows other(width, random);
          scalar::tile_extrema(other.rows, width, row.low_at(), row.high_at());
        }
        const std::size_t words = static_cast<std::size_t>(width + 511) / 512 * 8;
        std::vector<Words> memory(16, Words(words));
        std::vector<BitRows> rows(4);
        for (std::size_t i = 0; i < 16; ++i) rows[i / 4][i % 4] = memory[i].data();
        threshold_tiles(pixels.rows, width, tiles[0].row(), tiles[1].row(), tiles[2].row(), rule,
                        rows[0], rows[1]);
        scalar::threshold_tiles(pixels.rows, width, tiles[0].row(), tiles[1].row(), tiles[2].row(),
                                rule, rows[2], rows[3]);
        for (std::size_t i = 0; i < 8; ++i)
          ASSERT_EQ(memory[i], memory[i + 8]) << width << " " << i;
        // Without white rows the black ones are the same.
        Words black(words);
        threshold_tiles(pixels.rows, width, tiles[0].row(), tiles[1].row(), tiles[2].row(), rule,
                        {black.data(), nullptr, nullptr, nullptr}, {});
        ASSERT_EQ(black, memory[0]);
      }
    }
  });
}

TEST(StartKernels, StartsAreThoseOfThePlainLoop) {
  with_every_instruction_set([] {
    FixedRandom random(3);
    for (const int words : {1, 2, 3, 5, 8, 9}) {
      for (const int black_of_8 : {1, 4, 6, 7}) {
        const int rows = 20;
        const int stride = (words + kBitVectorWords - 1) / kBitVectorWords * kBitVectorWords + 8;
        Words bits(static_cast<std::size_t>(stride * (rows + kStartDepth + 1) + 8));
        for (int y = 0; y < rows + kStartDepth; ++y) {
          for (int w = 1; w <= words; ++w) {
            std::uint64_t& word = bits[static_cast<std::size_t>(y * stride + w)];
            for (int i = 0; i < 64; ++i) {
              word = word << 1 | static_cast<std::uint64_t>(below(random, 8) <
                                                            static_cast<std::uint64_t>(black_of_8));
            }
          }
        }
        const BitBlock block{bits.data() + stride + 1, stride};
        const int starts_stride = stride - 8;
        Words fast(static_cast<std::size_t>(starts_stride * rows)), plain(fast);
        find_starts(block, rows, words, fast.data(), starts_stride);
        scalar::find_starts(block, rows, words, plain.data(), starts_stride);
        for (int y = 0; y < rows; ++y) {
          for (int w = 0; w < words; ++w) {
            const auto i = static_cast<std::size_t>(y * starts_stride + w);
            ASSERT_EQ(fast[i], plain[i]) << words << " words, row " << y << ", word " << w;
          }
        }
      }
    }
  });
}

/// Points, some of them equal, with the padding that the kernels ask for.
struct Points {
  std::vector<float> x, y;
  int size;

  Points(int count, FixedRandom& random) : size(count) {
    for (int i = 0; i < count; ++i) {
      x.push_back(static_cast<float>(below(random, 40)));
      y.push_back(static_cast<float>(below(random, 40)) + 0.5f);
    }
    x.insert(x.end(), kOutlinePadding, x.back());
    y.insert(y.end(), kOutlinePadding, y.back());
  }
  OutlineView view() const { return {x.data(), y.data(), size}; }
};

TEST(OutlineKernels, FarthestPointsAreThoseOfThePlainLoop) {
  with_every_instruction_set([] {
    FixedRandom random(4);
    for (int count = 1; count < 70; ++count) {
      const Points points(count, random);
      const auto px = static_cast<float>(random.real(0, 40));
      const auto py = static_cast<float>(random.real(0, 40));
      ASSERT_EQ(farthest_point(points.view(), px, py),
                scalar::farthest_point(points.view(), px, py));
      const auto ex = static_cast<float>(random.real(-1, 1));
      const auto ey = static_cast<float>(random.real(-1, 1));
      const FarthestBothSides fast = farthest_both_sides(points.view(), px, py, ex, ey);
      const FarthestBothSides plain = scalar::farthest_both_sides(points.view(), px, py, ex, ey);
      ASSERT_EQ(fast.left, plain.left) << count;
      ASSERT_EQ(fast.right, plain.right) << count;
      ASSERT_EQ(fast.left_distance, plain.left_distance);
      ASSERT_EQ(fast.right_distance, plain.right_distance);
      for (const float most : {5.0f, 20.0f, 40.0f}) {
        // What follows the points takes no part.
        OutlineView fewer = points.view();
        fewer.size = std::max(1, count - 3);
        ASSERT_EQ(all_near_line(fewer, px, py, ex, ey, most),
                  scalar::all_near_line(fewer, px, py, ex, ey, most));
      }
    }
  });
}

TEST(HalveKernels, MeansAreThoseOfThePlainLoop) {
  with_every_instruction_set([] {
    FixedRandom random(6);
    for (const int pixels : kWidths) {
      const auto width = static_cast<std::size_t>(2 * pixels);
      const Bytes upper = random_bytes(width, random), lower = random_bytes(width, random);
      Bytes fast(static_cast<std::size_t>(pixels)), plain(fast);
      halve_rows(upper.data(), lower.data(), pixels, fast.data());
      scalar::halve_rows(upper.data(), lower.data(), pixels, plain.data());
      ASSERT_EQ(fast, plain) << pixels;
    }
  });
}

TEST(HalveKernels, HalvesAreRoundedUp) {
  const Bytes upper = {0, 1, 255, 255}, lower = {0, 1, 255, 254};
  Bytes out(2);
  halve_rows(upper.data(), lower.data(), 2, out.data());
  EXPECT_EQ(out, (Bytes{1, 255}));
}

/// Scan lines that go from dark to bright near pixel 4, with noise, and some that do not.
EdgeScans random_scans(int count, FixedRandom& random) {
  EdgeScans scans;
  scans.count = count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const std::uint64_t edge = 2 + below(random, 5);
    for (std::size_t k = 0; k < kScanPixels; ++k) {
      scans.gray[k][i] = static_cast<std::uint8_t>((k < edge ? 40 : 150) + below(random, 60));
    }
    scans.along[i] = static_cast<std::int32_t>(i * 3) - 20;
    scans.expected[i] = static_cast<std::int32_t>(3 * kParts + below(random, 2 * kParts));
  }
  return scans;
}

void expect_same(const EdgeSums& a, const EdgeSums& b) {
  EXPECT_EQ(a.n, b.n);
  EXPECT_EQ(a.along, b.along);
  EXPECT_EQ(a.off, b.off);
  EXPECT_EQ(a.along_along, b.along_along);
  EXPECT_EQ(a.along_off, b.along_off);
  EXPECT_EQ(a.off_off, b.off_off);
}

TEST(EdgeKernels, PointsAndSumsAreThoseOfThePlainLoop) {
  with_every_instruction_set([] {
    FixedRandom random(7);
    for (int count = 1; count <= kMaxEdgeScans; ++count) {
      const EdgeScans scans = random_scans(count, random);
      const int level = twice_middle_level(scans);
      ASSERT_EQ(level, scalar::twice_middle_level(scans));
      EdgePoints fast, plain;
      find_edge_points(scans, level, fast);
      scalar::find_edge_points(scans, level, plain);
      for (const float limit : {1e9f, 300.0f, 80.0f}) {
        drop_far_points(scans, 3.0f, 0.4f, limit, fast);
        scalar::drop_far_points(scans, 3.0f, 0.4f, limit, plain);
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
          ASSERT_EQ(fast.counts[i], plain.counts[i]) << count << " " << i;
          ASSERT_EQ(fast.off[i], plain.off[i]) << count << " " << i;
        }
        expect_same(sum_edge_points(scans, fast), scalar::sum_edge_points(scans, plain));
      }
    }
  });
}

}  // namespace
}  // namespace tagmint::detect
