#include "decode_lookup.h"

namespace tagmint::codec {

Match ListLookup::match_of(const FourTurns& turned, const Nearest& nearest) const {
  int turns = 0;
  while (hamming_distance(turned[static_cast<std::size_t>(turns)], codewords()[nearest.index]) !=
         nearest.distance) {
    ++turns;
  }
  const TagId id = tags_.ids.empty() ? static_cast<TagId>(nearest.index) : tags_.ids[nearest.index];
  return {id, nearest.distance, turns};
}

}  // namespace tagmint::codec
