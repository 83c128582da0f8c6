#include "search/near_list.h"

#include <algorithm>

namespace tagmint::codec {

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

bool NearList::excludes(std::uint32_t word, int bits) const {
  return near_kernels::excludes(data(), size(), word, (NearEntry{1} << bits) - 1);
}

}  // namespace tagmint::codec
