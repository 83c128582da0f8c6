#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/export.h"
#include "tagmint/codec/family.h"
#include "tagmint/codec/search/crew.h"

namespace tagmint::codec {

struct TAGMINT_API CompletenessOptions {
  /// 0 = all cores.
  int threads = 0;
  /// Asks the proof to end early.
  std::stop_token stop = {};
  /// Called from the calling thread, a few times a second: how many words of the space are judged,
  /// and how many there are.
  std::function<void(double words_done, double words_total)> progress = {};
  /// Who does the work; nothing = local_crew().
  CrewMaker crew = {};
};

/// What prove_complete() established.
struct TAGMINT_API Completeness {
  bool stopped = false;  ///< ended early; nothing is known
  /// A word that could be added to the family; none = the family is complete, unless stopped.
  std::optional<Codeword> addable;
};

/// Whether a family is complete: no further word is the declared distance from all turns of all
/// tags and from its own turns, and complex enough in one of its four turns. Judges the whole space
/// by the tree of the search (docs/lexicodes.md), below 16 bits and at 64 word by word. Which
/// addable word is told does not depend on threads or on the crew: the least one of the first
/// subtree that holds one.
///   cost     as phase 2 of search_lexicode(): 36 bits seconds, 41 bits a minute, beyond about 45
///            bits hours, 64 bits never; a family that is far from complete a moment
///   memory   of the crew, and 32 bytes for each open tag that a round of 0.2 s finds
TAGMINT_API Completeness prove_complete(const Family& family,
                                        const CompletenessOptions& options = {});

}  // namespace tagmint::codec
