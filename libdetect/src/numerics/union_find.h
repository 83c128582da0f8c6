#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tagmint::detect {

/// Disjoint sets over 0 .. n - 1, each element with a weight: union by weight, path halving
/// [TarjanVanLeeuwen1984].
class UnionFind {
 public:
  /// Forgets everything; keeps the memory.
  void clear() {
    parent_.clear();
    weight_.clear();
  }
  /// Adds an element as a set of its own; returns its number.
  std::uint32_t add(std::uint32_t weight = 1) {
    const auto element = static_cast<std::uint32_t>(parent_.size());
    parent_.push_back(element);
    weight_.push_back(weight);
    return element;
  }
  std::size_t size() const { return parent_.size(); }

  /// The root of the set that `element` is in.
  ///   cost   amortised inverse Ackermann
  std::uint32_t find(std::uint32_t element) {
    assert(element < parent_.size());
    while (parent_[element] != element) {
      parent_[element] = parent_[parent_[element]];
      element = parent_[element];
    }
    return element;
  }
  /// Makes one set of the two; returns its root, the root of the heavier one.
  std::uint32_t unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return a;
    if (weight_[a] < weight_[b]) std::swap(a, b);
    parent_[b] = a;
    weight_[a] += weight_[b];
    return a;
  }
  /// Sum of the weights of the set that `root` is the root of.
  std::uint32_t weight(std::uint32_t root) const {
    assert(parent_[root] == root);
    return weight_[root];
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> weight_;
};

}  // namespace tagmint::detect
