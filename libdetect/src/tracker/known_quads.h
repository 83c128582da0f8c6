#pragma once

#include <span>
#include <vector>

#include "pipeline/stage_types.h"

namespace tagmint::detect {

/// Quads by their place, to tell whether one of them is found again.
class KnownQuads {
 public:
  /// Takes the quads' places, divided by `scale`; keeps its memory.
  void assign(std::span<const Quad> quads, double scale);
  /// Whether one of them has nearly this middle and this area, and the same colours.
  ///   cost   O(log n), and a look at those of about the same height
  bool holds(const Quad& quad) const;

 private:
  struct Entry {
    double y = 0;
    double x = 0;
    double area = 0;
    bool reversed_border = false;
  };
  static Entry entry_of(const Quad& quad);

  std::vector<Entry> entries_;  // by y
};

}  // namespace tagmint::detect
