#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "tagmint/codec/complexity.h"
#include "tagmint/codec/export.h"
#include "tagmint/codec/family.h"
#include "tagmint/codec/layout.h"

namespace tagmint::codec {

/// Where a running search for a rotation code stands.
struct TAGMINT_API RotationCodeProgress {
  std::size_t tries_done = 0;  ///< of the present step: constructions times attempts
  std::size_t tries = 0;
  std::string step;  ///< "codes", "free codes", "inner levels", "unions of cosets"
  double tags = 0;   ///< of the largest code so far
};

struct TAGMINT_API RotationCodeOptions {
  Layout layout;
  int min_hamming = 0;
  /// Distances of inner levels, all above min_hamming, any order. Empty: a family as large as
  /// possible, with the levels that are found inside it.
  std::vector<int> levels = {};
  /// Which tags come first in a level; the plain ones are its last.
  Complexity complexity = {};
  std::uint64_t seed = 0;
  /// How often each construction is tried, each time with other random choices.
  int attempts = 1;
  /// 0 = all cores.
  int threads = 0;
  /// Asks the search to end early, without a result.
  std::stop_token stop = {};
  /// Called from the calling thread, after each try that it made.
  std::function<void(const RotationCodeProgress&)> progress = {};
};

struct TAGMINT_API RotationCodeResult {
  /// Without a name. Levels with their true distances; a generator where there are more than
  /// kMostListedTags tags, else codewords.
  FamilyParts parts;
  std::string construction;  ///< in words, for people
  bool stopped = false;      ///< by options.stop

  /// Whether there is a family: the search was not stopped, and found a tag.
  bool found() const { return !parts.levels.empty(); }
};

/// Families of rotation codes with at most so many tags are given as a list.
inline constexpr std::size_t kMostListedTags = 1024;

/// A family whose codewords are a code that quarter turns map to itself (docs/rotation-codes.md):
/// the best of what is found by
///   - climbing through closed linear codes, one dimension at a time, from nothing (quasi-cyclic
///     search) and from shortened codes of the literature, with one code inside the other for the
///     levels;
///   - free quasi-cyclic codes of up to 20 dimensions, lifted from codes of half as many;
///   - unions of cosets of a small code, where the layout has at most 25 bits and no levels are
///     asked for;
///   - for small families and at most 41 bits, further words by the lexicode search.
/// With levels the best chain is the one with the largest product of tags over its levels, the
/// whole family counted three times; without, the one with the most tags. Cells and a translation
/// are chosen so that many of the first tags pass the complexity rule. Deterministic for given
/// options but threads.
///   errors   std::invalid_argument for distances outside 1..bits, levels not above min_hamming,
///            no attempts
///   cost     seconds to a minute an attempt
TAGMINT_API RotationCodeResult search_rotation_code(const RotationCodeOptions& options);

/// The family of a result that found one; `name` empty = "rot" + bits + "h" + distance, with
/// the layout's prefix.
TAGMINT_API Family make_family(RotationCodeResult result, std::string name = {});

}  // namespace tagmint::codec
