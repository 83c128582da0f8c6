#include "decode_lookup.h"

#include "tagmint/codec/rotation.h"

namespace tagmint::codec {

std::optional<Match> ListLookup::decode(Codeword observed) const {
  Nearest best;
  int best_turns = 0;
  for (int turns = 0; turns < 4; ++turns, observed = rotate_quarter(observed, tags_.bits)) {
    const Nearest found = nearest(observed);
    if (!found.found() || found.distance > best.distance) continue;
    if (found.distance < best.distance) {
      best = found;
      best_turns = turns;
    } else if (found.tie || found.index != best.index) {
      best.tie = true;
    }
  }
  if (!best.found() || best.tie) return std::nullopt;
  const TagId id = tags_.ids.empty() ? static_cast<TagId>(best.index) : tags_.ids[best.index];
  return Match{id, best.distance, best_turns};
}

}  // namespace tagmint::codec
