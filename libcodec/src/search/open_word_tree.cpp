#include "search/open_word_tree.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace tagmint::codec {
namespace {

/// Bits still undecided at a node with `level` orbits to decide above the leaves.
constexpr int undecided_bits(int level) { return TreeOrder::kLeafBits + 4 * level; }

}  // namespace

OpenWordTree::OpenWordTree(const TreeOrder& order, const LeafPainter& painter,
                           std::span<const Codeword> turns, int radius, int paint_radius)
    : order_(order),
      painter_(painter),
      turns_(turns),
      radius_(radius),
      paint_radius_(paint_radius) {
  assert(radius >= 0 && paint_radius >= 0 && paint_radius <= radius);
  for (Node& node : nodes_) node.tiers.resize(paint_radius + 1);
}

int OpenWordTree::subtree_levels(const TreeOrder& order) {
  return std::min(order.levels(), kMostLevels);
}

std::uint64_t OpenWordTree::subtree_count(const TreeOrder& order) {
  return std::uint64_t{1} << (order.bits() - undecided_bits(subtree_levels(order)));
}

void OpenWordTree::list_subtree(std::uint64_t subtree, std::vector<Codeword>& open) {
  const int level = subtree_levels(order_);
  TreeOrder::Ties ties;
  for (int above = order_.levels() - level - 1; above >= 0; --above) {
    const unsigned nibble = subtree >> (4 * above) & 0xf;
    if (TreeOrder::breaks_order(ties, nibble)) return;
    ties = TreeOrder::after(ties, nibble);
  }
  const Codeword prefix = subtree << undecided_bits(level);
  make_root(prefix);
  descend(level, prefix, ties, open);
}

void OpenWordTree::make_root(Codeword prefix) {
  const int level = subtree_levels(order_);
  const Codeword undecided = low_mask(undecided_bits(level));
  Node& root = nodes_[level];
  for (NearList& list : root.tiers) list.clear();
  for (const Codeword turn : turns_) {
    const int left = radius_ - hamming_distance(turn & ~undecided, prefix);
    if (left < 0) continue;
    root.tiers[std::max(0, paint_radius_ - left)].push_back(
        near_entry(static_cast<std::uint32_t>(turn & undecided), left));
  }
  root.made = paint_radius_ + 1;
}

void OpenWordTree::descend(int level, Codeword prefix, TreeOrder::Ties ties,
                           std::vector<Codeword>& open) {
  if (level == 1) return list_twig(prefix, ties, open);
  const int shift = undecided_bits(level - 1);
  for (unsigned nibble = 0; nibble < 16; ++nibble) {
    if (TreeOrder::breaks_order(ties, nibble)) continue;
    Node& child = nodes_[level - 1];
    child.nibble = nibble;
    child.made = 0;
    descend(level - 1, prefix | Codeword{nibble} << shift, TreeOrder::after(ties, nibble), open);
  }
}

const NearList& OpenWordTree::tier(int level, int tier) {
  Node& node = nodes_[level];
  for (; node.made <= tier; ++node.made) {
    NearList& list = node.tiers[node.made];
    list.clear();
    // A radius only shrinks on the way down, so that the tiers further down the parent's list give
    // nothing to this one.
    for (int from = 0; from <= node.made; ++from) {
      list.append_narrowed(this->tier(level + 1, from), node.nibble, undecided_bits(level),
                           least_radius(node.made), most_radius(node.made));
    }
  }
  return node.tiers[tier];
}

void OpenWordTree::list_twig(Codeword prefix, TreeOrder::Ties ties, std::vector<Codeword>& open) {
  constexpr int kLevel = 1;
  unpainted_.clear();
  const NearList& painted = tier(kLevel, 0);
  LeafBits leaf;
  for (unsigned nibble = 0; nibble < 16; ++nibble) {
    if (TreeOrder::breaks_order(ties, nibble)) continue;
    leaf_list_.clear();
    leaf_list_.append_narrowed(painted, nibble, TreeOrder::kLeafBits, least_radius(0),
                               most_radius(0));
    if (!painter_.paint(leaf_list_, leaf)) collect_unpainted(nibble, leaf);
  }
  // Tier 0 once more: balls whose radius fell below the paint radius on the last step.
  for (int t = 0; t <= paint_radius_ && !unpainted_.empty(); ++t) {
    const NearList& list = tier(kLevel, t);
    std::erase_if(unpainted_,
                  [&](std::uint32_t word) { return list.excludes(word, undecided_bits(kLevel)); });
  }
  for (const std::uint32_t word : unpainted_) open.push_back(prefix | word);
}

void OpenWordTree::collect_unpainted(unsigned nibble, const LeafBits& leaf) {
  for (unsigned element = 0; element < leaf.elements.size(); ++element) {
    for (std::uint64_t left = ~leaf.elements[element]; left != 0; left &= left - 1) {
      unpainted_.push_back(nibble << TreeOrder::kLeafBits | element * 64 |
                           static_cast<unsigned>(std::countr_zero(left)));
    }
  }
}

}  // namespace tagmint::codec
