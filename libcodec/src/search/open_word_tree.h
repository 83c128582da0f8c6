#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "search/leaf_paint.h"
#include "search/near_list.h"
#include "search/paint_radius.h"
#include "search/tree_order.h"
#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// Lists the *open* words of parts of the space: those that are farther than `radius` from every
/// turn of a given set of codes. One tag's four turns are listed as one word (TreeOrder).
///
/// The tree decides the bits of a word from the top, one orbit a level. Each node keeps the code
/// turns that may still exclude words below it, with the radius that is left of them. They are kept
/// in tiers by that radius:
///
///     tier 0    radius >= p     large balls: narrowed down to the twigs and painted there
///     tier 1    radius == p-1   asked, one after the other, only about
///      ...        ...           the few words that painting left open,
///     tier p    radius == 0     and made only where there are enough such words
///
/// A *twig* is a node above 16 leaves, each of 4096 words. The words that painting leaves open are
/// asked about first at their twig. Where they are fewer than narrowing the next tier pays for,
/// they wait for those of the other twigs and are asked about one level up, where the lists are
/// longer but there already.
///
/// Holds the lists of one thread: at most (codes * 4) entries of 4 bytes for each tier of three
/// levels and once more for all tiers of a subtree, 8 bytes for a code turn, and 8 KiB for a twig.
class OpenWordTree {
 public:
  /// All share `order` and `painter`, which must outlive the object.
  ///   turns          the four turns of all codes, as tree words
  ///   radius         least distance - 1, >= 0
  ///   paint_radius   p above, 0..radius; a matter of speed alone
  OpenWordTree(const TreeOrder& order, const LeafPainter& painter, std::span<const Codeword> turns,
               int radius, int paint_radius);

  /// Number of subtrees that the space is cut into; those that hold no representative are empty.
  static std::uint64_t subtree_count(const TreeOrder& order);

  /// Appends the open words of one subtree, as tree words, to `open`. Words of which a block equals
  /// its partner may come in two turns.
  ///   subtree   0 .. subtree_count() - 1
  ///   cost      some hundred nanoseconds a leaf, 2^bits / 2^14 leaves in all
  void list_subtree(std::uint64_t subtree, std::vector<Codeword>& open);

 private:
  /// Levels of the tree below a subtree's root; 12 + 4 * 3 bits are what an entry holds.
  static constexpr int kMostLevels = 3;
  static constexpr int kTwigLevel = 1;

  /// A word by its undecided bits below the subtree's root.
  using SubtreeWord = std::uint32_t;

  /// The node that the walk through the tree is at, on one level.
  struct Node {
    std::vector<NearList> tiers;
    int made = 0;         // tiers 0 .. made - 1 are up to date
    unsigned nibble = 0;  // the bits of the orbit that lead to this node from the one above
    std::vector<SubtreeWord> waiting;  // not yet compared with the lists of this level
  };

  static int subtree_levels(const TreeOrder& order);
  void descend(int level, SubtreeWord prefix, TreeOrder::Ties ties);
  void list_twig(SubtreeWord prefix, TreeOrder::Ties ties);
  /// Compares the words that wait at a node with its tiers, or lets them wait one level up.
  void ask(int level, int first_tier);
  const NearList& tier(int level, int tier);
  int least_radius(int tier) const { return paint_radius_ - tier; }
  int most_radius(int tier) const { return tier == 0 ? kMaxBits : paint_radius_ - tier; }

  const TreeOrder& order_;
  const LeafPainter& painter_;
  const SplitTurns turns_;
  int radius_;
  int paint_radius_;
  PaintPlan plan_;
  NearList reaching_;                        // all tiers of the subtree's root
  std::array<Node, kMostLevels + 1> nodes_;  // [level]: orbits still to decide above the leaves
  NearList smallest_balls_;                  // of a twig: radius p
  NearList larger_balls_;                    // and larger ones
  NearList equal_balls_, rest_;
  TwigBits twig_;
  std::vector<SubtreeWord> open_;  // of the subtree
};

}  // namespace tagmint::codec
