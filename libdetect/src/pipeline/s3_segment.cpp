#include "pipeline/s3_segment.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace tagmint::detect {
namespace {

/// First x at or after `x` whose pixel is not `value`; `width` when there is none. Eight pixels are
/// compared at a time: their bytes XOR the value repeated are zero where they agree.
int end_of_run(const std::uint8_t* row, int x, int width, std::uint8_t value) {
  const std::uint64_t repeated = value * std::uint64_t{0x0101010101010101};
  for (; x + 8 <= width; x += 8) {
    std::uint64_t pixels;
    std::memcpy(&pixels, row + x, sizeof pixels);
    const std::uint64_t difference = pixels ^ repeated;
    if (difference == 0) continue;
    const int zero_bits = std::endian::native == std::endian::little ? std::countr_zero(difference)
                                                                     : std::countl_zero(difference);
    return x + zero_bits / 8;
  }
  while (x < width && row[x] == value) ++x;
  return x;
}

/// Appends the black and white runs of a row and makes each a set of its own.
void find_runs(const std::uint8_t* row, int width, SegmentScratch& s) {
  for (int x = 0; x < width;) {
    const std::uint8_t value = row[x];
    const int end = end_of_run(row, x + 1, width, value);
    if (value != kUnknown) {
      s.runs.push_back({x, end, value});
      s.sets.add(static_cast<std::uint32_t>(end - x));
    }
    x = end;
  }
}

/// Joins the runs of a row, [here, end), with those of the row above, [above, here). Both are in
/// order of x, so one walk along both finds all that touch.
void join_rows(std::size_t above, std::size_t here, std::size_t end, SegmentScratch& s) {
  std::size_t first = above;
  for (std::size_t i = here; i < end; ++i) {
    const PixelRun run = s.runs[i];
    while (first < here && s.runs[first].end < run.begin) ++first;
    for (std::size_t j = first; j < here && s.runs[j].begin <= run.end; ++j) {
      const PixelRun other = s.runs[j];
      if (other.value != run.value) continue;
      // Runs that only meet at a corner are neighbours when white, not when black.
      const bool share_an_edge = other.begin < run.end && run.begin < other.end;
      if (share_an_edge || run.value == kWhite) {
        s.sets.unite(static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(i));
      }
    }
  }
}

/// Numbers the sets in the order of their first runs and writes the number of each pixel.
void write_labels(SegmentScratch& s, Labels& out) {
  s.root_label.assign(s.runs.size(), kNoComponent);
  out.size.clear();
  out.label.resize(std::size_t(out.width) * out.height);
  for (int y = 0; y < out.height; ++y) {
    std::uint32_t* row = out.label.data() + std::size_t(y) * out.width;
    int x = 0;
    for (std::size_t i = s.row_begin[y]; i < s.row_begin[y + 1]; ++i) {
      const std::uint32_t root = s.sets.find(static_cast<std::uint32_t>(i));
      if (s.root_label[root] == kNoComponent) {
        s.root_label[root] = static_cast<std::uint32_t>(out.size.size());
        out.size.push_back(s.sets.weight(root));
      }
      const PixelRun run = s.runs[i];
      std::fill(row + x, row + run.begin, kNoComponent);
      std::fill(row + run.begin, row + run.end, s.root_label[root]);
      x = run.end;
    }
    std::fill(row + x, row + out.width, kNoComponent);
  }
}

}  // namespace

void segment(ImageView three_valued, SegmentScratch& scratch, Labels& out) {
  out.width = std::max(three_valued.width, 0);
  out.height = std::max(three_valued.height, 0);
  scratch.runs.clear();
  scratch.sets.clear();
  scratch.row_begin.assign(1, 0);
  for (int y = 0; y < out.height; ++y) {
    const std::size_t here = scratch.runs.size();
    find_runs(three_valued.row(y), out.width, scratch);
    scratch.row_begin.push_back(scratch.runs.size());
    if (y > 0) join_rows(scratch.row_begin[y - 1], here, scratch.runs.size(), scratch);
  }
  write_labels(scratch, out);
}

}  // namespace tagmint::detect
