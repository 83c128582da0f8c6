#include "pipeline/s4_cluster.h"

#include <algorithm>
#include <bit>

namespace tagmint::detect {
namespace {

/// Spreads a pair of labels over the table: multiplication by 2^64 / golden ratio, top bits used
/// [Knuth1998, section 6.4].
std::size_t slot_of(std::uint64_t key, std::size_t slots) {
  const std::uint64_t mixed = (key ^ (key >> 32)) * 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>(mixed >> (64 - std::countr_zero(slots)));
}

void insert(std::vector<PairTable::Slot>& slots, std::uint64_t key, std::uint32_t cluster) {
  std::size_t i = slot_of(key, slots.size());
  while (slots[i].used) i = (i + 1) & (slots.size() - 1);
  slots[i] = {key, cluster, true};
}

/// Number of the cluster of `key`; a new one when it is seen for the first time.
std::uint32_t cluster_of(std::uint64_t key, ClusterScratch& s) {
  std::vector<PairTable::Slot>& slots = s.table.slots;
  for (std::size_t i = slot_of(key, slots.size()); slots[i].used;
       i = (i + 1) & (slots.size() - 1)) {
    if (slots[i].key == key) return slots[i].cluster;
  }
  const auto cluster = static_cast<std::uint32_t>(s.keys.size());
  s.keys.push_back(key);
  s.counts.push_back(0);
  if (2 * s.keys.size() > slots.size()) {
    slots.assign(2 * slots.size(), {});
    for (std::uint32_t c = 0; c < cluster; ++c) insert(slots, s.keys[c], c);
  }
  insert(slots, key, cluster);
  return cluster;
}

/// One walk over the runs; remembers the pair of components that it met last, because the next
/// stretch often belongs to the same one.
class BoundaryWalk {
 public:
  BoundaryWalk(const Components& components, const ClusterOptions& options, ClusterScratch& scratch)
      : components_(components),
        min_component_(static_cast<std::uint32_t>(std::max(options.min_component_pixels, 0))),
        scratch_(scratch) {}

  void run() {
    for (int y = 0; y < components_.height; ++y) {
      const std::size_t begin = components_.row_begin[y], end = components_.row_begin[y + 1];
      const std::size_t end_below = y + 1 < components_.height ? components_.row_begin[y + 2] : end;
      walk_row(y, begin, end, end_below);
    }
  }

 private:
  /// Runs [begin, end) of row y, and [end, end_below) of the row below; both in order of x.
  void walk_row(int y, std::size_t begin, std::size_t end, std::size_t end_below) {
    const std::vector<PixelRun>& runs = components_.runs;
    std::size_t first = end;
    for (std::size_t i = begin; i < end; ++i) {
      const PixelRun& run = runs[i];
      if (!large_enough(run)) continue;
      if (i + 1 < end && runs[i + 1].begin == run.end) meet_beside(y, run, runs[i + 1]);
      while (first < end_below && runs[first].end < run.begin) ++first;
      for (std::size_t j = first; j < end_below && runs[j].begin <= run.end; ++j) {
        if (runs[j].value != run.value && large_enough(runs[j])) meet_below(y, run, runs[j]);
      }
    }
  }

  bool large_enough(const PixelRun& run) const {
    return components_.size[run.component] >= min_component_;
  }

  /// The last pixel of a run and the first of the next one, which then has the other colour.
  void meet_beside(int y, const PixelRun& run, const PixelRun& next) {
    if (!large_enough(next)) return;
    add(cluster_of_pair(run, next), run, run.end - 1, run.end, y, 1, 0);
  }

  /// All pairs of a pixel of `run` and one of `lower` below it, below to the left or to the right:
  /// the places where `run` and `lower`, moved by the step, overlap.
  void meet_below(int y, const PixelRun& run, const PixelRun& lower) {
    const std::uint32_t cluster = cluster_of_pair(run, lower);
    for (int dx = -1; dx <= 1; ++dx) {
      const int begin = std::max(run.begin, lower.begin - dx);
      const int end = std::min(run.end, lower.end - dx);
      if (begin < end) add(cluster, run, begin, end, y, dx, 1);
    }
  }

  std::uint32_t cluster_of_pair(const PixelRun& a, const PixelRun& b) {
    const PixelRun& black = a.value == kBlack ? a : b;
    const PixelRun& white = a.value == kBlack ? b : a;
    const std::uint64_t key = std::uint64_t{black.component} << 32 | white.component;
    if (scratch_.keys.empty() || key != last_key_) {
      last_key_ = key;
      last_cluster_ = cluster_of(key, scratch_);
    }
    return last_cluster_;
  }

  void add(std::uint32_t cluster, const PixelRun& run, int begin, int end, int y, int dx, int dy) {
    scratch_.counts[cluster] += static_cast<std::size_t>(end - begin);
    scratch_.stretches.push_back({cluster, begin, end, y, static_cast<std::int8_t>(dx),
                                  static_cast<std::int8_t>(dy),
                                  static_cast<std::int8_t>(run.value == kBlack ? 1 : -1)});
  }

  const Components& components_;
  std::uint32_t min_component_;
  ClusterScratch& scratch_;
  std::uint64_t last_key_ = 0;
  std::uint32_t last_cluster_ = 0;
};

/// Puts the points of each large enough cluster together: counting sort by cluster. Returns the
/// number of all points, small clusters included.
std::size_t gather(const ClusterScratch& found, std::size_t min_points,
                   std::vector<std::size_t>& targets, Clusters& out) {
  targets.resize(found.counts.size());
  out.begin.assign(1, 0);
  std::size_t all = 0;
  for (std::size_t c = 0; c < found.counts.size(); ++c) {
    all += found.counts[c];
    if (found.counts[c] < min_points) continue;
    targets[c] = out.begin.back();
    out.begin.push_back(out.begin.back() + found.counts[c]);
  }
  out.points.resize(out.begin.back());
  for (const BoundaryStretch& s : found.stretches) {
    if (found.counts[s.cluster] < min_points) continue;
    BoundaryPoint* point = out.points.data() + targets[s.cluster];
    targets[s.cluster] += static_cast<std::size_t>(s.end - s.begin);
    // Half-way between the centres (x, y) + 1/2 and (x + dx, y + dy) + 1/2.
    const float middle_x = 0.5f * static_cast<float>(1 + s.dx);
    const float middle_y = static_cast<float>(s.y) + 0.5f * static_cast<float>(1 + s.dy);
    const auto gx = static_cast<float>(s.to_white * s.dx);
    const auto gy = static_cast<float>(s.to_white * s.dy);
    for (int x = s.begin; x < s.end; ++x) {
      *point++ = {static_cast<float>(x) + middle_x, middle_y, gx, gy};
    }
  }
  return all;
}

}  // namespace

void cluster(const Components& components, const ClusterOptions& options, ClusterScratch& scratch,
             Clusters& out, DetectStats& stats) {
  constexpr std::size_t kFirstSlots = 1024;
  scratch.table.slots.assign(std::max(scratch.table.slots.size(), kFirstSlots), {});
  scratch.keys.clear();
  scratch.counts.clear();
  scratch.stretches.clear();
  BoundaryWalk(components, options, scratch).run();
  const std::size_t points = gather(
      scratch, static_cast<std::size_t>(std::max(options.min_points, 1)), scratch.targets, out);
  stats.boundary_points += static_cast<std::int64_t>(points);
  stats.clusters += static_cast<std::int64_t>(out.count());
}

}  // namespace tagmint::detect
