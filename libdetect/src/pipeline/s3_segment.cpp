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
void find_runs(const std::uint8_t* row, int width, std::vector<PixelRun>& runs, UnionFind& sets) {
  for (int x = 0; x < width;) {
    const std::uint8_t value = row[x];
    const int end = end_of_run(row, x + 1, width, value);
    if (value != kUnknown) {
      runs.push_back({x, end, kNoComponent, value});
      sets.add(static_cast<std::uint32_t>(end - x));
    }
    x = end;
  }
}

/// Joins the runs of a row, [here, end), with those of the row above, [above, here). Both are in
/// order of x, so one walk along both finds all that touch.
void join_rows(std::size_t above, std::size_t here, std::size_t end,
               const std::vector<PixelRun>& runs, UnionFind& sets) {
  std::size_t first = above;
  for (std::size_t i = here; i < end; ++i) {
    const PixelRun run = runs[i];
    while (first < here && runs[first].end < run.begin) ++first;
    for (std::size_t j = first; j < here && runs[j].begin <= run.end; ++j) {
      const PixelRun other = runs[j];
      if (other.value != run.value) continue;
      // Runs that only meet at a corner are neighbours when white, not when black.
      const bool share_an_edge = other.begin < run.end && run.begin < other.end;
      if (share_an_edge || run.value == kWhite) {
        sets.unite(static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(i));
      }
    }
  }
}

/// Numbers the sets in the order of their first runs, notes the number in each run, and finds the
/// boxes.
void number_components(SegmentScratch& s, Components& out) {
  s.root_component.assign(out.runs.size(), kNoComponent);
  out.size.clear();
  out.box.clear();
  for (int y = 0; y < out.height; ++y) {
    for (std::size_t i = out.row_begin[y]; i < out.row_begin[y + 1]; ++i) {
      PixelRun& run = out.runs[i];
      const std::uint32_t root = s.sets.find(static_cast<std::uint32_t>(i));
      std::uint32_t& component = s.root_component[root];
      if (component == kNoComponent) {
        component = static_cast<std::uint32_t>(out.size.size());
        out.size.push_back(s.sets.weight(root));
        out.box.push_back({run.begin, y, run.end, y + 1});
      }
      run.component = component;
      PixelBox& box = out.box[component];
      box.left = std::min(box.left, run.begin);
      box.right = std::max(box.right, run.end);
      box.bottom = y + 1;
    }
  }
}

}  // namespace

void segment(ImageView three_valued, SegmentScratch& scratch, Components& out) {
  out.width = std::max(three_valued.width, 0);
  out.height = std::max(three_valued.height, 0);
  out.runs.clear();
  scratch.sets.clear();
  out.row_begin.assign(1, 0);
  for (int y = 0; y < out.height; ++y) {
    const std::size_t here = out.runs.size();
    find_runs(three_valued.row(y), out.width, out.runs, scratch.sets);
    out.row_begin.push_back(out.runs.size());
    if (y > 0) join_rows(out.row_begin[y - 1], here, out.runs.size(), out.runs, scratch.sets);
  }
  number_components(scratch, out);
}

std::vector<std::uint32_t> component_of_each_pixel(const Components& components) {
  std::vector<std::uint32_t> of_pixel(std::size_t(components.width) * components.height,
                                      kNoComponent);
  for (int y = 0; y < components.height; ++y) {
    std::uint32_t* row = of_pixel.data() + std::size_t(y) * components.width;
    for (std::size_t i = components.row_begin[y]; i < components.row_begin[y + 1]; ++i) {
      const PixelRun& run = components.runs[i];
      std::fill(row + run.begin, row + run.end, run.component);
    }
  }
  return of_pixel;
}

}  // namespace tagmint::detect
