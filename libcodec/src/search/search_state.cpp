#include "tagmint/codec/search/search_state.h"

namespace tagmint::codec {

void SearchState::apply(const SearchStep& step) {
  if (phase == SearchPhase::List && step.phase == SearchPhase::Walk) walk_at_least = 2 * step.done;
  phase = step.phase;
  switch (step.phase) {
    case SearchPhase::Walk:
      subtrees_listed = 0;
      open_tags.clear();
      words_walked = step.done;
      codewords.insert(codewords.end(), step.words.begin(), step.words.end());
      walked_codes = codewords.size();
      break;
    case SearchPhase::List:
      subtrees_listed = step.done;
      open_tags.insert(open_tags.end(), step.words.begin(), step.words.end());
      break;
    case SearchPhase::Choose:
      chosen_to = step.done;
      codewords.insert(codewords.end(), step.words.begin(), step.words.end());
      break;
  }
}

}  // namespace tagmint::codec
