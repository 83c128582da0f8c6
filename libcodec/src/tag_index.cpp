#include "tagmint/codec/tag_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <mutex>
#include <span>
#include <stdexcept>
#include <utility>

#include "level_tags.h"

namespace tagmint::codec {

/// One level's own tags, found at the first use.
struct TagIndex::Level {
  explicit Level(const LevelPlaces& level_places) : places(level_places) {}

  LevelPlaces places;
  TagId first_id = 0;  // tags of the levels before
  std::once_flag found;
  LevelTags tags;
};

TagIndex::TagIndex(SharedRotationCode code, const Layout& layout, const Complexity& rule)
    : code_(std::move(code)), layout_(layout), rule_(rule) {
  if (code_ == nullptr) throw std::invalid_argument("an index of tags needs a code, not null");
  if (code_->bits() != layout_.bits()) {
    throw std::invalid_argument(fmt::format(
        "words of {} bits do not fit a layout with {} data cells", code_->bits(), layout_.bits()));
  }
  for (std::size_t i = 0; i < code_->levels().size(); ++i) {
    levels_.push_back(std::make_unique<Level>(LevelPlaces(*code_, i)));
    if (i > 0) levels_[i]->first_id = static_cast<TagId>(code_->tags(i - 1));
  }
}

TagIndex::~TagIndex() = default;

const TagIndex::Level& TagIndex::level(std::size_t number) const {
  Level& level = *levels_[number];
  std::call_once(level.found, [&] {
    level.tags = find_level_tags(*code_, number, layout_, rule_);
    assert(level.first_id + level.tags.accepted.ones() + level.tags.plain.ones() ==
           code_->tags(number));
  });
  return level;
}

Codeword TagIndex::codeword(TagId id) const {
  assert(id < code_->tags());
  std::size_t number = 0;
  while (id >= code_->tags(number)) ++number;
  const Level& own = level(number);
  const std::size_t among = id - own.first_id;
  const std::size_t accepted = own.tags.accepted.ones();
  const std::size_t place =
      among < accepted ? own.tags.accepted.select(among) : own.tags.plain.select(among - accepted);
  return code_->word(own.places.address(place));
}

std::vector<Codeword> TagIndex::codewords(TagId first, std::size_t count) const {
  assert(first + count <= code_->tags());
  std::vector<Codeword> words;
  words.reserve(count);
  for (std::size_t number = 0; words.size() < count; ++number) {
    const std::size_t wanted = first + words.size();
    if (wanted >= code_->tags(number)) continue;
    const Level& own = level(number);
    std::size_t among = wanted - own.first_id;  // the next tag's number in the row to look at
    for (const RankedBits* row : {&own.tags.accepted, &own.tags.plain}) {
      const std::size_t end = std::min(row->ones(), among + count - words.size());
      row->visit_ones(among, end, [&](std::size_t place) {
        words.push_back(code_->word(own.places.address(place)));
      });
      among = std::max(among, row->ones()) - row->ones();
    }
  }
  return words;
}

std::optional<TagIndex::Place> TagIndex::find(Codeword word) const {
  const std::optional<RotationCode::Address> found = code_->find(word);
  if (!found) return std::nullopt;
  RotationCode::Address smallest = *found;
  RotationCode::Address turned = *found;
  int turns = 0;
  for (int turn = 1; turn < 4; ++turn) {
    turned = code_->turned(turned);
    if (turn == 2 && turned == *found) return std::nullopt;  // two words or one: no tag
    if (turned >= smallest) continue;
    smallest = turned;
    turns = turn;
  }
  std::size_t number = 0;
  while (!levels_[number]->places.holds(smallest)) ++number;
  const Level& own = level(number);
  const std::size_t place = own.places.place(smallest);
  const std::size_t among = own.tags.accepted.test(place)
                                ? own.tags.accepted.rank(place)
                                : own.tags.accepted.ones() + own.tags.plain.rank(place);
  return Place{own.first_id + static_cast<TagId>(among), turns};
}

std::size_t TagIndex::plain(std::size_t number) const { return level(number).tags.plain.ones(); }

std::size_t TagIndex::table_bytes(std::size_t number) const {
  std::size_t bytes = 0;
  for (const auto& level : std::span(levels_).first(number + 1)) {
    bytes += 2 * RankedBits::bytes(level->places.size());
  }
  return bytes;
}

}  // namespace tagmint::codec
