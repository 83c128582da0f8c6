#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/export.h"
#include "tagmint/codec/layout.h"

namespace tagmint::codec {

/// How plain patterns, which nature likes to imitate, are kept out of a family.
enum class ComplexityRule {
  None,        ///< every word will do
  Rectangles,  ///< a greedy painter must need at least `threshold` rectangles (the classic
               ///< families)
  Energy,  ///< the rendered tag must have at least threshold * 2 * cells colour changes (AprilTag
           ///< 3)
};

/// A complexity rule and its threshold. Text form: "rectangles:10", "energy:0.3333", "none".
struct TAGMINT_API Complexity {
  ComplexityRule rule = ComplexityRule::None;
  double threshold = 0.0;
  friend bool operator==(const Complexity&, const Complexity&) = default;
};

/// Parses the text form: "rectangles:" and a whole number of at least 1, "energy:" and a share
/// between 0 and 1, or "none". Throws std::invalid_argument with a suggestion for a misspelt rule.
TAGMINT_API Complexity parse_complexity(std::string_view text);

/// "rectangles", "energy" or "none".
TAGMINT_API std::string_view rule_name(ComplexityRule rule);

/// The text form; parse_complexity() turns it back.
TAGMINT_API std::string to_string(const Complexity& complexity);

/// Number of rectangles that a greedy painter needs to draw the data cells of `word`
/// (docs/lexicodes.md, "The rule"): each time the rectangle and colour that
/// lower the number of wrong cells most, the first one on ties. The grid is the bounding box of the
/// data cells seen as the published generator visited it, that is turned by 180 degrees against the
/// printed tag; cells that are not data never count as wrong. Not rotation invariant.
///   word     in the layout's codeword order
///   cost     O(rectangles * side^4) cell look-ups; use it last
TAGMINT_API int count_rectangles(const Layout& layout, Codeword word);

/// Number of colour changes between 4-neighbours over the whole rendered tag, border included,
/// absent cells left out. Rotation invariant. Cost: O(width^2).
TAGMINT_API int count_colour_changes(const Layout& layout, Codeword word);

/// Judges many words of one layout by one rule: tables are made once. Copyable, safe to share
/// between threads.
class TAGMINT_API ComplexityJudge {
 public:
  ComplexityJudge(const Layout& layout, const Complexity& complexity);
  /// Whether `word`, in codeword order, is complex enough.
  bool accepts(Codeword word) const;
  /// The figure that the rule compares with its threshold: rectangles, or colour changes / (2 *
  /// cells); 0 for None.
  double measure(Codeword word) const;

 private:
  struct Tables;

  Complexity complexity_;
  std::shared_ptr<const Tables> tables_;
};

}  // namespace tagmint::codec
