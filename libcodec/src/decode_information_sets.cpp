// The words of the code within the radius are found without a list (information_set_search.h), and
// the index of its tags tells id and turns of each. A code closed under quarter turns has every
// turn of a tag among its words, so that one search of the observed word as it stands serves all
// four turns.

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>
#include <vector>

#include "decode_lookup.h"
#include "information_set_search.h"

namespace tagmint::codec {
namespace {

/// The words of a level of the code.
InformationSetSearch make_search(const RotationCode& code, std::size_t level, int radius) {
  const RotationCodeLevel& part = code.levels()[level];
  std::vector<Codeword> shifts;
  for (const Codeword coset : code.cosets().first(part.cosets)) {
    shifts.push_back(code.translation() ^ coset);
  }
  const auto basis = code.basis().first(static_cast<std::size_t>(part.dimension));
  return InformationSetSearch(basis, shifts, code.bits(), radius);
}

/// The nearest of the tags offered so far, and how far others need be looked for.
struct NearestTag {
  Match match;
  Codeword word = 0;  // the turn of the tag that is so near
  bool found = false;
  bool tie = false;
  int limit;  // a tag farther than that changes nothing

  void offer(Codeword turn, const TagIndex::Place& place, int distance) {
    if (!found || distance < match.hamming) {
      match = {place.id, distance, place.turns};
      word = turn;
      found = true;
      tie = false;
    } else if (place.id != match.id) {
      tie = true;
    } else {
      match.rotation = std::min(match.rotation, place.turns);
    }
    // A word can be no nearer than 0 and is nearest alone there.
    limit = tie || distance == 0 ? distance - 1 : distance;
  }
};

class InformationSetLookup final : public Decoder::Lookup {
 public:
  InformationSetLookup(SharedTagIndex index, std::size_t level, std::span<const TagId> ids,
                       int radius)
      : search_(make_search(*index->code(), level, radius)),
        index_(std::move(index)),
        level_(level),
        ids_(ids),
        radius_(radius) {}

  std::optional<Match> decode(Codeword observed) const override {
    NearestTag nearest{.match = {}, .limit = radius_};
    search_.visit_near(observed, [&](Codeword word, int distance) {
      if (nearest.found && word == nearest.word) return nearest.limit;  // found once more
      const std::optional<TagIndex::Place> place = index_->find(word);
      if (place && is_chosen(place->id)) nearest.offer(word, *place, distance);
      return nearest.limit;
    });
    if (!nearest.found || nearest.tie) return std::nullopt;
    return nearest.match;
  }

  std::size_t table_bytes() const override {
    return search_.table_bytes() + index_->table_bytes(level_);
  }

 private:
  bool is_chosen(TagId id) const {
    return ids_.empty() || std::binary_search(ids_.begin(), ids_.end(), id);
  }

  InformationSetSearch search_;
  SharedTagIndex index_;
  std::size_t level_;
  std::span<const TagId> ids_;
  int radius_;
};

}  // namespace

std::unique_ptr<const Decoder::Lookup> make_information_set_lookup(SharedTagIndex index,
                                                                   std::size_t level,
                                                                   std::span<const TagId> ids,
                                                                   int radius) {
  assert(index != nullptr && level < index->code()->levels().size());
  return std::make_unique<const InformationSetLookup>(std::move(index), level, ids, radius);
}

}  // namespace tagmint::codec
