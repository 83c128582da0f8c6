#include "pipeline/s4_cluster.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

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

/// One walk over the image; remembers the pair that it met last, because the next boundary point
/// mostly belongs to the same one.
class BoundaryScan {
 public:
  BoundaryScan(ImageView image, const Labels& labels, const ClusterOptions& options,
               ClusterScratch& scratch)
      : image_(image),
        labels_(labels),
        min_component_(static_cast<std::uint32_t>(std::max(options.min_component_pixels, 0))),
        scratch_(scratch) {}

  void run() {
    for (int y = 0; y < image_.height; ++y) scan_row(y);
  }

 private:
  /// The pixel pair (x, y), (x + dx, y + dy) is black and white: keeps its midpoint.
  void add(int x, int y, int dx, int dy) {
    const std::size_t here = std::size_t(y) * labels_.width + x;
    const std::size_t there = std::size_t(y + dy) * labels_.width + x + dx;
    const std::uint32_t label = labels_.label[here], other = labels_.label[there];
    if (labels_.size[label] < min_component_ || labels_.size[other] < min_component_) return;
    const bool black_here = image_.at(x, y) == kBlack;
    const std::uint64_t key =
        black_here ? std::uint64_t{label} << 32 | other : std::uint64_t{other} << 32 | label;
    if (!has_last_ || key != last_key_) {
      last_key_ = key;
      last_cluster_ = cluster_of(key, scratch_);
      has_last_ = true;
    }
    ++scratch_.counts[last_cluster_];
    const int sign = black_here ? 1 : -1;
    scratch_.pending.push_back({last_cluster_, 2 * x + 1 + dx, 2 * y + 1 + dy,
                                static_cast<std::int16_t>(sign * dx),
                                static_cast<std::int16_t>(sign * dy)});
  }

  /// All four neighbours of a pixel, as far as they are in the image.
  void scan_pixel(int x, int y) {
    const int value = image_.at(x, y);
    const auto differs = [&](int dx, int dy) {
      return x + dx >= 0 && x + dx < image_.width && y + dy < image_.height &&
             value + image_.at(x + dx, y + dy) == kBlack + kWhite;
    };
    if (value == kUnknown) return;
    if (differs(1, 0)) add(x, y, 1, 0);
    if (differs(-1, 1)) add(x, y, -1, 1);
    if (differs(0, 1)) add(x, y, 0, 1);
    if (differs(1, 1)) add(x, y, 1, 1);
  }

  /// Top bit of each byte set where one of a, b is black (00) and the other white (ff): only then
  /// do both bit 7 and bit 0 of the byte differ, for unknown is 7f.
  static constexpr std::uint64_t black_beside_white(std::uint64_t a, std::uint64_t b) {
    const std::uint64_t difference = a ^ b;
    return difference & (difference << 7) & 0x8080808080808080u;
  }

  static std::uint64_t load(const std::uint8_t* pixels) {
    std::uint64_t word;
    std::memcpy(&word, pixels, sizeof word);
    return word;
  }

  /// The top bit of byte `i` as it lies in memory.
  static constexpr std::uint64_t byte_bit(int i) {
    return std::uint64_t{0x80} << 8 * (std::endian::native == std::endian::little ? i : 7 - i);
  }

  /// Eight pixels from x on, all of whose neighbours are in the image.
  void scan_eight(int x, int y, const std::uint8_t* row, const std::uint8_t* next) {
    const std::uint64_t pixels = load(row + x);
    const std::uint64_t right = black_beside_white(pixels, load(row + x + 1));
    const std::uint64_t below_left = black_beside_white(pixels, load(next + x - 1));
    const std::uint64_t below = black_beside_white(pixels, load(next + x));
    const std::uint64_t below_right = black_beside_white(pixels, load(next + x + 1));
    const std::uint64_t any = right | below_left | below | below_right;
    if (any == 0) return;
    for (int i = 0; i < 8; ++i) {
      const std::uint64_t bit = byte_bit(i);
      if (!(any & bit)) continue;
      if (right & bit) add(x + i, y, 1, 0);
      if (below_left & bit) add(x + i, y, -1, 1);
      if (below & bit) add(x + i, y, 0, 1);
      if (below_right & bit) add(x + i, y, 1, 1);
    }
  }

  void scan_row(int y) {
    int x = 0;
    if (y + 1 < image_.height) {
      scan_pixel(x++, y);
      const std::uint8_t* row = image_.row(y);
      const std::uint8_t* next = image_.row(y + 1);
      for (; x + 9 <= image_.width; x += 8) scan_eight(x, y, row, next);
    }
    for (; x < image_.width; ++x) scan_pixel(x, y);
  }

  ImageView image_;
  const Labels& labels_;
  std::uint32_t min_component_;
  ClusterScratch& scratch_;
  bool has_last_ = false;
  std::uint64_t last_key_ = 0;
  std::uint32_t last_cluster_ = 0;
};

/// Puts the points of each large enough cluster together: counting sort by cluster.
void gather(const ClusterScratch& found, std::size_t min_points, std::vector<std::size_t>& targets,
            Clusters& out) {
  targets.resize(found.counts.size());
  out.begin.assign(1, 0);
  for (std::size_t c = 0; c < found.counts.size(); ++c) {
    if (found.counts[c] < min_points) continue;
    targets[c] = out.begin.back();
    out.begin.push_back(out.begin.back() + found.counts[c]);
  }
  out.points.resize(out.begin.back());
  for (const PendingPoint& p : found.pending) {
    if (found.counts[p.cluster] < min_points) continue;
    out.points[targets[p.cluster]++] = {0.5f * static_cast<float>(p.twice_x),
                                        0.5f * static_cast<float>(p.twice_y),
                                        static_cast<float>(p.gx), static_cast<float>(p.gy)};
  }
}

}  // namespace

void cluster(ImageView three_valued, const Labels& labels, const ClusterOptions& options,
             ClusterScratch& scratch, Clusters& out, DetectStats& stats) {
  assert(labels.width == std::max(three_valued.width, 0));
  assert(labels.height == std::max(three_valued.height, 0));
  constexpr std::size_t kFirstSlots = 1024;
  scratch.table.slots.assign(std::max(scratch.table.slots.size(), kFirstSlots), {});
  scratch.keys.clear();
  scratch.counts.clear();
  scratch.pending.clear();
  if (!three_valued.empty()) BoundaryScan(three_valued, labels, options, scratch).run();
  gather(scratch, static_cast<std::size_t>(std::max(options.min_points, 1)), scratch.targets, out);
  stats.boundary_points += static_cast<std::int64_t>(scratch.pending.size());
  stats.clusters += static_cast<std::int64_t>(out.count());
}

}  // namespace tagmint::detect
