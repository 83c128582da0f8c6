#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "search/leaf_paint.h"
#include "search/open_word_tree.h"
#include "search/sieve.h"
#include "search/tree_order.h"
#include "tagmint/codec/search/crew.h"
#include "tagmint/codec/search/order.h"

namespace tagmint::codec {

/// The crew that is this process's threads.
class LocalCrew : public SearchCrew {
 public:
  /// `paint_radius` as OpenWordTree; nothing = chosen by the number of codes.
  LocalCrew(const SearchRules& rules, int threads, std::optional<int> paint_radius = std::nullopt);

  void learn(std::span<const Codeword> codes) override;
  SiftedWords sift(std::uint64_t first, std::uint64_t count) override;
  std::vector<Codeword> list_open(std::uint64_t first, std::uint64_t count) override;

 private:
  /// What list_open() needs for as long as the codes stay the same.
  struct Forest {
    Forest(int bits, int min_hamming, std::span<const Codeword> codes, int threads,
           std::optional<int> paint_radius);

    TreeOrder order;
    LeafPainter painter;
    std::vector<Codeword> turns;      // of all codes, as tree words
    std::vector<OpenWordTree> trees;  // one a thread
  };

  std::vector<Codeword> list_subtree(OpenWordTree& tree, std::uint64_t subtree) const;

  SearchRules rules_;
  int threads_;
  std::optional<int> paint_radius_;
  Walk walk_;
  Sieve sieve_;
  std::vector<Codeword> codes_;
  std::unique_ptr<Forest> forest_;
};

}  // namespace tagmint::codec
