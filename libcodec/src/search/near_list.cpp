#include "search/near_list.h"

#include <algorithm>

namespace tagmint::codec {

SplitTurns::SplitTurns(std::span<const Codeword> turns)
    : size_(turns.size()),
      upper_(turns.size() + NearList::kPadding),
      lower_(turns.size() + NearList::kPadding) {
  for (std::size_t i = 0; i < turns.size(); ++i) {
    upper_[i] = static_cast<std::uint32_t>(turns[i] >> 32);
    lower_[i] = static_cast<std::uint32_t>(turns[i]);
  }
}

void NearList::pad() {
  std::fill_n(entries_.begin() + static_cast<std::ptrdiff_t>(size_), kPadding, kNothing);
}

void NearList::make_room(std::size_t more) {
  const std::size_t needed = size_ + more + kPadding;
  if (entries_.size() < needed) entries_.resize(std::max(needed, 2 * entries_.size()), kNothing);
}

void NearList::push_back(NearEntry entry) {
  make_room(1);
  entries_[size_++] = entry;
  entries_[size_ - 1 + kPadding] = kNothing;
}

void NearList::append_narrowed(const NearList& parent, unsigned nibble, int shift, int least,
                               int most) {
  make_room(parent.size());
  const near_kernels::Narrowing narrowing{NearEntry{nibble} << shift, NearEntry{0xf} << shift,
                                          near_entry(0, least), near_entry(0, most + 1)};
  size_ += near_kernels::narrow(parent.data(), parent.size(), narrowing, entries_.data() + size_);
  pad();
}

void NearList::append_some(const NearList& source, int least, int most) {
  make_room(source.size());
  const near_kernels::Narrowing narrowing{0, 0, near_entry(0, least), near_entry(0, most + 1)};
  size_ += near_kernels::narrow(source.data(), source.size(), narrowing, entries_.data() + size_);
  pad();
}

void NearList::take_equal(const NearList& source, int radius, NearList& larger) {
  const std::size_t count = source.size();
  clear();
  make_room(count);
  if (&larger != &source) {
    larger.clear();
    larger.make_room(count);
  }
  const near_kernels::Parts parts =
      near_kernels::part(source.data(), count, radius, entries_.data(), larger.entries_.data());
  size_ = parts.equal;
  larger.size_ = parts.larger;
  pad();
  larger.pad();
}

void NearList::append_reaching(const SplitTurns& turns, Codeword prefix, int undecided,
                               int radius) {
  make_room(turns.size());
  const near_kernels::Subtree subtree{prefix, static_cast<NearEntry>(low_mask(undecided)), radius};
  size_ += near_kernels::reach(turns, subtree, entries_.data() + size_);
  pad();
}

void NearList::exclude_from(std::vector<std::uint32_t>& words, int bits) const {
  words.resize(
      near_kernels::keep_open(data(), size(), words, static_cast<NearEntry>(low_mask(bits))));
}

}  // namespace tagmint::codec
