#pragma once

#include <vector>

#include "search/rotation/chain_search.h"
#include "tagmint/codec/complexity.h"
#include "tagmint/codec/layout.h"
#include "tagmint/codec/linear_map.h"
#include "tagmint/codec/rotation_code.h"

namespace tagmint::codec {

/// Which place of a block each place of a code goes to, and how many blocks further it begins.
/// Moving whole cycles of four cells, turned against each other or not, keeps every distance and
/// commutes with quarter turns.
struct Placement {
  int bits = 0;
  std::vector<int> place;   ///< a permutation of 0 .. bits / 4 - 1
  std::vector<int> blocks;  ///< 0..3 each

  /// What it makes of a word.
  LinearMap map() const;
};

/// A chain in the cells of a layout: the codes' words moved and one translation added to all, so
/// that as many as possible are tags, and then as many of the first levels' tags as possible pass
/// the complexity rule. By the coset trick a translation t of which t ^ turn(t) lies in the first
/// level's code leaves everything closed; where no word of the level differs from t by one that a
/// half turn keeps, each orbit is a tag.
///   chain       one code at least; bits as the layout has
///   tries       exchanges of places tried, by hill climbing; each judges some thousand words
RotationCodeParts place_chain(const CodeChain& chain, const Layout& layout, const Complexity& rule,
                              int tries, RandomChoice& random);

/// The same for a list of tags, whose translation keeps to words that quarter turns do not change.
std::vector<Codeword> place_tags(const std::vector<Codeword>& tags, const Layout& layout,
                                 const Complexity& rule, int tries, RandomChoice& random);

}  // namespace tagmint::codec
