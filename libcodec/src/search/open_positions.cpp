#include "search/open_positions.h"

#include <algorithm>
#include <atomic>

#include "search/leaf_paint.h"
#include "search/open_word_tree.h"
#include "search/paint_radius.h"
#include "search/parallel.h"
#include "search/search_control.h"
#include "search/tree_order.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

using End = OpenPositions::End;

std::vector<Codeword> turns_as_tree_words(const OpenPositionsRequest& request,
                                          const TreeOrder& order) {
  std::vector<Codeword> turns;
  turns.reserve(4 * request.codewords.size());
  for (const Codeword code : request.codewords) {
    for (int turn = 0; turn < 4; ++turn) {
      turns.push_back(order.to_tree(rotate(code, order.bits(), turn)));
    }
  }
  return turns;
}

/// The work shared by the threads: subtrees are handed out one by one.
class Listing {
 public:
  Listing(const OpenPositionsRequest& request, SearchControl& control)
      : request_(request),
        control_(control),
        order_(request.walk.bits()),
        turns_(turns_as_tree_words(request, order_)),
        subtrees_(OpenWordTree::subtree_count(order_)),
        open_(request.threads) {}

  OpenPositions run() {
    const int radius = request_.min_hamming - 1;
    const int paint_radius =
        request_.paint_radius.value_or(best_paint_radius(order_.bits(), radius, turns_.size()));
    run_workers(request_.threads, [&](int worker) {
      OpenWordTree tree(order_, painter_, turns_, radius, paint_radius);
      work(worker, tree);
    });
    if (end_ != End::Done) return {end_, {}};
    return {End::Done, positions()};
  }

 private:
  void work(int worker, OpenWordTree& tree) {
    const auto started = control_.elapsed();
    std::vector<Codeword> found;  // tree words of one subtree
    for (std::uint64_t i; end_ == End::Done && (i = next_++) < subtrees_;) {
      if (control_.must_end()) return give_up(End::Interrupted);
      found.clear();
      tree.list_subtree(scattered(i), found);
      keep(found, open_[worker]);
      if (open_count_ > request_.most) return give_up(End::TooMany);
      if (worker == 0) watch(static_cast<double>(i + 1) / static_cast<double>(subtrees_), started);
    }
  }

  /// A permutation of the subtrees, so that those done so far are a fair sample of all. (Their
  /// number is a power of two and the factor is odd.)
  std::uint64_t scattered(std::uint64_t i) const {
    constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15;  // 2^64 / golden ratio
    return i * kOdd & (subtrees_ - 1);
  }

  void keep(const std::vector<Codeword>& found, std::vector<Codeword>& kept) {
    const std::size_t before = kept.size();
    for (const Codeword tree_word : found) {
      const Codeword word = order_.to_codeword(tree_word);
      if (self_distance(word, order_.bits()) >= request_.min_hamming) kept.push_back(word);
    }
    open_count_ += kept.size() - before;
  }

  /// In the calling thread: reports, and sees whether the time limit can be kept.
  void watch(double share, std::chrono::duration<double> started) {
    const double words_total = static_cast<double>(request_.last) + 1;
    const double words_left = words_total - static_cast<double>(request_.after);
    const double words_done = kListingShareOfProgress * share * words_left;
    control_.report(request_.after + static_cast<std::uint64_t>(words_done), words_total,
                    request_.codewords.size());
    constexpr double kSample = 0.01;  // enough subtrees to foretell the rest
    const auto time_left = control_.time_left();
    if (!time_left || share < kSample) return;
    const auto needed = (control_.elapsed() - started) * ((1 - share) / share);
    if (needed > *time_left) give_up(End::TooSlow);
  }

  void give_up(End end) {
    End done = End::Done;
    end_.compare_exchange_strong(done, end);
  }

  std::vector<std::uint64_t> positions() {
    std::vector<std::uint64_t> positions;
    positions.reserve(4 * open_count_);
    for (std::vector<Codeword>& words : open_) {
      for (const Codeword word : words) {
        for (int turn = 0; turn < 4; ++turn) {
          const std::uint64_t position =
              request_.walk.position_of(rotate(word, order_.bits(), turn));
          if (position > request_.after && position - 1 <= request_.last) {
            positions.push_back(position);
          }
        }
      }
      words = {};
    }
    std::sort(positions.begin(), positions.end());
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    return positions;
  }

  const OpenPositionsRequest& request_;
  SearchControl& control_;
  const TreeOrder order_;
  const LeafPainter painter_;
  const std::vector<Codeword> turns_;
  const std::uint64_t subtrees_;
  std::vector<std::vector<Codeword>> open_;  // [worker], as codewords
  std::atomic<std::uint64_t> next_{0};
  std::atomic<std::size_t> open_count_{0};
  std::atomic<End> end_{End::Done};
};

}  // namespace

OpenPositions list_open_positions(const OpenPositionsRequest& request, SearchControl& control) {
  return Listing(request, control).run();
}

}  // namespace tagmint::codec
