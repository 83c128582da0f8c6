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
  s.outlines.emplace_back();
  if (2 * s.keys.size() > slots.size()) {
    slots.assign(2 * slots.size(), {});
    for (std::uint32_t c = 0; c < cluster; ++c) insert(slots, s.keys[c], c);
  }
  insert(slots, key, cluster);
  return cluster;
}

/// Calls stretch(begin, end, dx, dy) for each stretch of pairs of pixels between two runs that
/// meet: (x, y) of the upper run and (x + dx, y + dy) of the other, begin <= x < end.
template <typename Stretch>
void for_each_stretch(const PixelRun& upper, const PixelRun* lower, const Stretch& stretch) {
  if (lower == nullptr) {  // its last pixel and the first of the run beside it
    stretch(upper.end - 1, upper.end, 1, 0);
    return;
  }
  // Below to the left, below, below to the right: where the lower run, moved back by the step,
  // overlaps the upper one.
  for (int dx = -1; dx <= 1; ++dx) {
    const int begin = std::max(upper.begin, lower->begin - dx);
    const int end = std::min(upper.end, lower->end - dx);
    if (begin < end) stretch(begin, end, dx, 1);
  }
}

int to_white(const PixelRun& upper) { return upper.value == kBlack ? 1 : -1; }

/// One walk over the runs; remembers the pair of components that it met last, because the next
/// meeting often belongs to the same one.
class BoundaryWalk {
 public:
  BoundaryWalk(const Components& components, const ClusterOptions& options, ClusterScratch& scratch)
      : components_(components),
        min_component_(static_cast<std::uint32_t>(std::max(options.min_component_pixels, 0))),
        outer_(outer_colour(options)),
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
    const PixelRun* const runs = components_.runs.data();
    std::size_t first = end;
    for (std::size_t i = begin; i < end; ++i) {
      const PixelRun& run = runs[i];
      if (!large_enough(run)) continue;
      if (i + 1 < end && runs[i + 1].begin == run.end && large_enough(runs[i + 1])) {
        meet(y, i, run, RunMeeting::kBeside, runs[i + 1]);
      }
      while (first < end_below && runs[first].end < run.begin) ++first;
      for (std::size_t j = first; j < end_below && runs[j].begin <= run.end; ++j) {
        if (runs[j].value != run.value && large_enough(runs[j])) {
          meet(y, i, run, static_cast<std::uint32_t>(j), runs[j]);
        }
      }
    }
  }

  /// The colour that has to be outside, if it has to be one.
  static std::optional<std::uint8_t> outer_colour(const ClusterOptions& options) {
    if (!options.limits || options.limits->normal_borders == options.limits->reversed_borders) {
      return std::nullopt;
    }
    return options.limits->normal_borders ? kWhite : kBlack;
  }

  /// Whether `outer` may lie around `inner`: a component inside another one ends before it on all
  /// four sides, one around it, though perhaps not all the way, does on two sides at most.
  bool may_lie_around(const PixelRun& outer, const PixelRun& inner) const {
    const PixelBox& o = components_.box[outer.component];
    const PixelBox& i = components_.box[inner.component];
    return (o.left <= i.left) + (o.top <= i.top) + (o.right >= i.right) + (o.bottom >= i.bottom) >=
           2;
  }

  bool large_enough(const PixelRun& run) const {
    return components_.size[run.component] >= min_component_;
  }

  void meet(int y, std::size_t upper_index, const PixelRun& upper, std::uint32_t lower_index,
            const PixelRun& other) {
    if (outer_) {
      const bool upper_is_outer = upper.value == *outer_;
      if (!may_lie_around(upper_is_outer ? upper : other, upper_is_outer ? other : upper)) return;
    }
    const std::uint32_t cluster = cluster_of_pair(upper, other);
    scratch_.meetings.push_back({cluster, static_cast<std::uint32_t>(upper_index), lower_index, y});
    OutlineSums& outline = scratch_.outlines[cluster];
    for_each_stretch(upper, lower_index == RunMeeting::kBeside ? nullptr : &other,
                     [&](int begin, int end, int dx, int dy) {
                       outline.add(begin, end, y, dx, dy, to_white(upper));
                     });
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

  const Components& components_;
  std::uint32_t min_component_;
  std::optional<std::uint8_t> outer_;
  ClusterScratch& scratch_;
  std::uint64_t last_key_ = 0;
  std::uint32_t last_cluster_ = 0;
};

/// Decides which clusters are kept, and where their points go.
void choose_clusters(const ClusterOptions& options, ClusterScratch& s, Clusters& out,
                     DetectStats& stats) {
  const std::int64_t min_points = std::max(options.min_points, 1);
  s.targets.resize(s.outlines.size());
  s.kept.assign(s.outlines.size(), 0);
  out.begin.assign(1, 0);
  for (std::size_t c = 0; c < s.outlines.size(); ++c) {
    const std::int64_t points = s.outlines[c].points();
    stats.boundary_points += points;
    if (points < min_points) continue;
    ++stats.clusters;
    if (options.limits) {
      const OutlineVerdict verdict = judge_outline(s.outlines[c].outline(), *options.limits);
      count_refusal(verdict, stats);
      if (verdict != OutlineVerdict::Promising) continue;
    }
    s.kept[c] = 1;
    s.targets[c] = out.begin.back();
    out.begin.push_back(out.begin.back() + static_cast<std::size_t>(points));
  }
}

/// Makes the points of the clusters kept, those of each together: counting sort by cluster.
void make_points(const Components& components, ClusterScratch& s, Clusters& out) {
  out.points.resize(out.begin.back());
  for (const RunMeeting& m : s.meetings) {
    if (s.kept[m.cluster] == 0) continue;
    const PixelRun& upper = components.runs[m.upper];
    const PixelRun* lower = m.lower == RunMeeting::kBeside ? nullptr : &components.runs[m.lower];
    BoundaryPoint* point = out.points.data() + s.targets[m.cluster];
    for_each_stretch(upper, lower, [&](int begin, int end, int dx, int dy) {
      // Half-way between the centres (x, y) + 1/2 and (x + dx, y + dy) + 1/2.
      const float middle_x = 0.5f * static_cast<float>(1 + dx);
      const float middle_y = static_cast<float>(m.y) + 0.5f * static_cast<float>(1 + dy);
      const auto gx = static_cast<float>(to_white(upper) * dx);
      const auto gy = static_cast<float>(to_white(upper) * dy);
      for (int x = begin; x < end; ++x) {
        *point++ = {static_cast<float>(x) + middle_x, middle_y, gx, gy};
      }
    });
    s.targets[m.cluster] = static_cast<std::size_t>(point - out.points.data());
  }
}

}  // namespace

void cluster(const Components& components, const ClusterOptions& options, ClusterScratch& scratch,
             Clusters& out, DetectStats& stats) {
  constexpr std::size_t kFirstSlots = 1024;
  scratch.table.slots.assign(std::max(scratch.table.slots.size(), kFirstSlots), {});
  scratch.keys.clear();
  scratch.outlines.clear();
  scratch.meetings.clear();
  BoundaryWalk(components, options, scratch).run();
  choose_clusters(options, scratch, out, stats);
  make_points(components, scratch, out);
}

}  // namespace tagmint::detect
