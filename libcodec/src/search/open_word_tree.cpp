#include "search/open_word_tree.h"

#include <algorithm>
#include <cassert>

namespace tagmint::codec {
namespace {

/// Bits still undecided at a node with `level` orbits to decide above the leaves.
constexpr int undecided_bits(int level) { return TreeOrder::kLeafBits + 4 * level; }

/// Fewest words that pay for narrowing a tier; measured, and of little weight.
constexpr std::size_t kWorthNarrowing = 8;

}  // namespace

OpenWordTree::OpenWordTree(const TreeOrder& order, const LeafPainter& painter,
                           std::span<const Codeword> turns, int radius, int paint_radius)
    : order_(order),
      painter_(painter),
      turns_(turns),
      radius_(radius),
      paint_radius_(paint_radius),
      plan_(best_paint_plan(order.bits(), radius, turns.size(), paint_radius)) {
  assert(radius >= 0 && paint_radius >= 0 && paint_radius <= radius);
  for (Node& node : nodes_) node.tiers.resize(paint_radius_ + 1);
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
  reaching_.clear();
  reaching_.append_reaching(turns_, prefix, undecided_bits(level), radius_);
  nodes_[level].made = 0;
  open_.clear();
  descend(level, 0, ties);
  for (const SubtreeWord word : open_) open.push_back(prefix | word);
}

void OpenWordTree::descend(int level, SubtreeWord prefix, TreeOrder::Ties ties) {
  if (level == kTwigLevel) return list_twig(prefix, ties);
  const int shift = undecided_bits(level - 1);
  for (unsigned nibble = 0; nibble < 16; ++nibble) {
    if (TreeOrder::breaks_order(ties, nibble)) continue;
    Node& child = nodes_[level - 1];
    child.nibble = nibble;
    child.made = 0;
    descend(level - 1, prefix | nibble << shift, TreeOrder::after(ties, nibble));
  }
  ask(level, 0);
}

const NearList& OpenWordTree::tier(int level, int tier) {
  Node& node = nodes_[level];
  const bool is_root = level == subtree_levels(order_);
  for (; node.made <= tier; ++node.made) {
    NearList& list = node.tiers[node.made];
    const int least = least_radius(node.made);
    const int most = most_radius(node.made);
    list.clear();
    if (is_root) {
      list.append_some(reaching_, least, most);
      continue;
    }
    // A radius only shrinks on the way down, so that the tiers further down the parent's list give
    // nothing to this one.
    for (int from = 0; from <= node.made; ++from) {
      list.append_narrowed(this->tier(level + 1, from), node.nibble, undecided_bits(level), least,
                           most);
    }
  }
  return node.tiers[tier];
}

void OpenWordTree::list_twig(SubtreeWord prefix, TreeOrder::Ties ties) {
  twig_.elements.fill(0);
  // Balls of the same radius together, so that the loops of the painter are alike for all.
  smallest_balls_.take_equal(tier(kTwigLevel, 0), paint_radius_, larger_balls_);
  painter_.paint(smallest_balls_, paint_radius_, plan_.depth(paint_radius_), twig_);
  const NearList* left = &larger_balls_;
  for (int radius = paint_radius_ + 1; left->size() > 0; ++radius) {
    equal_balls_.take_equal(*left, radius, rest_);
    painter_.paint(equal_balls_, radius, plan_.depth(radius), twig_);
    left = &rest_;
  }
  std::vector<SubtreeWord>& words = nodes_[kTwigLevel].waiting;
  for (unsigned leaf = 0; leaf < 16; ++leaf) {
    if (TreeOrder::breaks_order(ties, leaf)) continue;
    LeafPainter::append_unpainted(twig_, leaf, prefix, words);
  }
  // Tier 0 once more, for its balls were not painted on all rows.
  larger_balls_.exclude_from(words, undecided_bits(kTwigLevel));
  smallest_balls_.exclude_from(words, undecided_bits(kTwigLevel));
  ask(kTwigLevel, 1);
}

void OpenWordTree::ask(int level, int first_tier) {
  Node& node = nodes_[level];
  std::vector<SubtreeWord>& words = node.waiting;
  std::vector<SubtreeWord>* next = &open_;
  for (int t = first_tier; t <= paint_radius_ && !words.empty(); ++t) {
    // Above, the lists of all tiers count again: a ball that has this radius here may have had a
    // larger one there.
    if (level < subtree_levels(order_) && node.made <= t && words.size() < kWorthNarrowing) {
      next = &nodes_[level + 1].waiting;
      break;
    }
    tier(level, t).exclude_from(words, undecided_bits(level));
  }
  next->insert(next->end(), words.begin(), words.end());
  words.clear();
}

}  // namespace tagmint::codec
