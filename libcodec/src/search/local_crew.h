#pragma once

#include <chrono>
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

/// What a LocalCrew may be told; matters of speed, never of the result.
struct LocalCrewTuning {
  /// As OpenWordTree; nothing = chosen by the number of codes.
  std::optional<int> paint_radius = std::nullopt;
  /// Whether to sift the walk with WalkSieve where that is faster.
  bool walk_by_groups = true;
};

/// The crew that is this process's threads.
class LocalCrew : public SearchCrew {
 public:
  LocalCrew(const SearchRules& rules, int threads, const LocalCrewTuning& tuning = {});

  void learn(std::span<const Codeword> codes) override;
  SiftedWords sift(std::uint64_t first, std::uint64_t count) override;
  std::vector<Codeword> list_open(std::uint64_t first, std::uint64_t count) override;
  std::chrono::duration<double> round_length() const override;

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
  LocalCrewTuning tuning_;
  Walk walk_;
  Sieve sieve_;
  std::vector<Codeword> codes_;
  std::unique_ptr<Forest> forest_;
};

}  // namespace tagmint::codec
