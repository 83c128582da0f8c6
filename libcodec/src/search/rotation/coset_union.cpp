#include "search/rotation/coset_union.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <optional>

#include "tagmint/codec/linear_map.h"

namespace tagmint::codec {
namespace {

/// The classes of all words modulo a kernel, numbered: classes add like words.
class Classes {
 public:
  using Number = std::uint32_t;

  explicit Classes(const TurnCode& kernel) : kernel_(kernel) {
    Codeword pivots = 0;
    for (const Codeword row : kernel.rows()) pivots |= std::bit_floor(row);
    std::vector<Codeword> numbers;
    for (int bit = 0; bit < kernel.bits(); ++bit) {
      if ((pivots >> bit & 1) == 0) units_.push_back(Codeword{1} << bit);
    }
    for (int bit = 0; bit < kernel.bits(); ++bit) {
      numbers.push_back(number_of_reduced(kernel.reduce(Codeword{1} << bit)));
    }
    number_ = LinearMap(numbers);
    std::vector<Codeword> turned;
    for (const Codeword unit : units_) turned.push_back(number_(rotate_quarter(unit, bits())));
    turn_ = LinearMap(turned);
  }

  int bits() const { return kernel_.bits(); }
  Number count() const { return Number{1} << units_.size(); }
  Number of(Codeword word) const { return static_cast<Number>(number_(word)); }
  Number turned(Number number) const { return static_cast<Number>(turn_(number)); }

  /// The least word of a class.
  Codeword word(Number number) const {
    Codeword word = 0;
    for (std::size_t i = 0; i < units_.size(); ++i) {
      if (number >> i & 1) word |= units_[i];
    }
    return word;
  }

  /// All words of a class.
  std::vector<Codeword> words(Number number) const {
    std::vector<Codeword> words = {word(number)};
    for (const Codeword row : kernel_.rows()) {
      const std::size_t half = words.size();
      for (std::size_t i = 0; i < half; ++i) words.push_back(words[i] ^ row);
    }
    return words;
  }

 private:
  Codeword number_of_reduced(Codeword word) const {
    Codeword number = 0;
    for (std::size_t i = 0; i < units_.size(); ++i) {
      if ((word & units_[i]) != 0) number |= Codeword{1} << i;
    }
    return number;
  }

  const TurnCode& kernel_;
  std::vector<Codeword> units_;  // the bits that no pivot stands at
  LinearMap number_;
  LinearMap turn_;
};

/// Marks the class of `word` and of all words with up to `more` further bits below `below`.
void mark_light(const Classes& classes, Codeword word, int below, int more,
                std::vector<bool>& light) {
  light[classes.of(word)] = true;
  if (more == 0) return;
  for (int bit = 0; bit < below; ++bit) {
    mark_light(classes, word | Codeword{1} << bit, bit, more - 1, light);
  }
}

/// A turn orbit of cosets.
struct Node {
  std::vector<Classes::Number> cosets;  // 1, 2 or 4 of them, each the turn of the one before
};

/// Which orbits of cosets may stand together.
class CosetGraph {
 public:
  CosetGraph(const TurnCode& kernel, int distance)
      : classes_(kernel), light_(classes_.count(), false) {
    mark_light(classes_, 0, kernel.bits(), distance - 1, light_);
    for (Classes::Number number = 0; number < classes_.count(); ++number) {
      if (auto node = make_node(number)) nodes_.push_back(std::move(*node));
    }
  }

  std::size_t size() const { return nodes_.size(); }

  /// In quarters of a tag, without the kernel's share.
  int weight(std::size_t node) const { return static_cast<int>(nodes_[node].cosets.size()); }

  /// Whether two different nodes are too near.
  bool conflict(std::size_t a, std::size_t b) const {
    const Classes::Number first = nodes_[a].cosets.front();
    const auto& others = nodes_[b].cosets;
    return std::any_of(others.begin(), others.end(),
                       [&](Classes::Number other) { return light_[first ^ other]; }) ||
           (others.size() < nodes_[a].cosets.size() && conflict(b, a));
  }

  /// One word of each tag of a node.
  void append_tags(std::size_t node, std::vector<Codeword>& tags) const {
    // An orbit of four cosets has each tag once in each; of fewer, once in each turn that stays.
    const auto& cosets = nodes_[node].cosets;
    for (const Codeword word : classes_.words(cosets.front())) {
      bool least = true;
      for (int turn = 1; turn < 4; ++turn) {
        const Codeword turned = rotate(word, classes_.bits(), turn);
        if (classes_.of(turned) == cosets.front() && turned < word) least = false;
      }
      if (least) tags.push_back(word);
    }
  }

 private:
  /// The orbit of a coset, where this is its least one and it keeps the distance by itself.
  std::optional<Node> make_node(Classes::Number number) const {
    Node node{{number}};
    for (auto next = classes_.turned(number); next != number; next = classes_.turned(next)) {
      if (next < number || light_[number ^ next]) return std::nullopt;
      node.cosets.push_back(next);
    }
    if (node.cosets.size() < 4) {
      // A turn stays in the coset: the words differ by one of the kernel, which must not be 0.
      for (const Codeword word : classes_.words(number)) {
        if (rotate(word, classes_.bits(), 2) == word) return std::nullopt;
      }
    }
    return node;
  }

  Classes classes_;
  std::vector<bool> light_;  // by class: holds a word of weight below the distance
  std::vector<Node> nodes_;
};

/// A set of nodes without conflicts, and how it changes.
class IndependentSet {
 public:
  explicit IndependentSet(const CosetGraph& graph)
      : graph_(graph), conflicts_(graph.size(), 0), inside_(graph.size(), false) {}

  int weight() const { return weight_; }
  const std::vector<std::size_t>& members() const { return members_; }
  bool holds(std::size_t node) const { return inside_[node]; }
  /// Members that are too near to `node`.
  int conflicts(std::size_t node) const { return conflicts_[node]; }

  /// Takes `node` in and all that is too near to it out.
  void force(std::size_t node) {
    for (std::size_t i = members_.size(); i-- > 0;) {
      if (graph_.conflict(node, members_[i])) remove(i);
    }
    members_.push_back(node);
    inside_[node] = true;
    weight_ += graph_.weight(node);
    count(node, 1);
  }

 private:
  void remove(std::size_t index) {
    const std::size_t node = members_[index];
    members_.erase(members_.begin() + static_cast<std::ptrdiff_t>(index));
    inside_[node] = false;
    weight_ -= graph_.weight(node);
    count(node, -1);
  }

  void count(std::size_t node, int change) {
    for (std::size_t other = 0; other < conflicts_.size(); ++other) {
      if (other != node && graph_.conflict(node, other)) conflicts_[other] += change;
    }
  }

  const CosetGraph& graph_;
  std::vector<std::size_t> members_;
  std::vector<int> conflicts_;
  std::vector<bool> inside_;
  int weight_ = 0;
};

/// The nodes that the next step may take in: those without conflict, else those with one and not
/// just thrown out.
std::vector<std::size_t> choices(const CosetGraph& graph, const IndependentSet& set,
                                 const std::vector<std::size_t>& barred_until, std::size_t step) {
  std::vector<std::size_t> free;
  std::vector<std::size_t> exchange;
  for (std::size_t node = 0; node < graph.size(); ++node) {
    if (set.holds(node)) continue;
    if (set.conflicts(node) == 0) free.push_back(node);
    if (set.conflicts(node) == 1 && barred_until[node] <= step) exchange.push_back(node);
  }
  return free.empty() ? exchange : free;
}

}  // namespace

std::vector<Codeword> unite_cosets(const TurnCode& kernel, int distance, RandomChoice& random,
                                   WorkBudget& budget) {
  assert(kernel.bits() - kernel.dimension() <= kMostClassBits);
  constexpr std::size_t kLongestBar = 10;      // steps that a node stays out, at most
  constexpr std::size_t kStepsPerShake = 100;  // a random node is forced in once in so many
  const CosetGraph graph(kernel, distance);
  if (graph.size() == 0) return {};
  IndependentSet set(graph);
  std::vector<std::size_t> best;
  int best_weight = 0;
  std::vector<std::size_t> barred_until(graph.size(), 0);
  for (std::size_t step = 0; !budget.is_spent(); ++step) {
    budget.spend(4.0 * static_cast<double>(graph.size()));
    const std::vector<std::size_t> next = choices(graph, set, barred_until, step);
    const bool shake = next.empty() || random.below(kStepsPerShake) == 0;
    const std::vector<std::size_t> before = set.members();
    set.force(shake ? random.below(graph.size()) : random.of(next));
    for (const std::size_t node : before) {
      if (!set.holds(node)) barred_until[node] = step + 1 + random.below(kLongestBar);
    }
    if (set.weight() > best_weight) {
      best_weight = set.weight();
      best = set.members();
    }
  }
  std::vector<Codeword> tags;
  for (const std::size_t node : best) graph.append_tags(node, tags);
  return tags;
}

}  // namespace tagmint::codec
