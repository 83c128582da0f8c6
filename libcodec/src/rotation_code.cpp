#include "tagmint/codec/rotation_code.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "echelon.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

template <typename... Arguments>
[[noreturn]] void refuse(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  throw std::invalid_argument(fmt::format(text, std::forward<Arguments>(arguments)...));
}

void check_words(const RotationCodeParts& parts) {
  if (parts.bits < 1 || parts.bits > kMaxBits || parts.bits % 4 > 1) {
    refuse(
        "a rotation code of {} bits is not possible; 1 to 64 with a remainder of 0 or 1 by 4 are",
        parts.bits);
  }
  const auto check_bits = [&](std::string_view what, Codeword word) {
    if ((word & ~low_mask(parts.bits)) == 0) return;
    refuse("{} ({}) has more than {} bits", what, to_hex(word), parts.bits);
  };
  for (std::size_t i = 0; i < parts.basis.size(); ++i) {
    check_bits(fmt::format("basis word {}", i), parts.basis[i]);
  }
  check_bits("the translation", parts.translation);
  for (std::size_t i = 0; i < parts.cosets.size(); ++i) {
    check_bits(fmt::format("coset {}", i), parts.cosets[i]);
  }
}

void check_size(const RotationCodeParts& parts) {
  if (parts.cosets.empty()) refuse("a rotation code needs at least one coset");
  const std::size_t dimension = parts.basis.size();
  if (dimension > 30 || parts.cosets.size() > RotationCode::kMostWords >> dimension) {
    refuse("{} cosets of {} basis words are more than 2^30 words", parts.cosets.size(), dimension);
  }
}

void check_level_sizes(const RotationCodeParts& parts) {
  const auto& levels = parts.levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const bool too_small = levels[i].dimension < 0 || levels[i].cosets == 0;
    const bool shrinks = i > 0 && (levels[i].dimension < levels[i - 1].dimension ||
                                   levels[i].cosets < levels[i - 1].cosets);
    const bool same = i > 0 && levels[i] == levels[i - 1];
    if (too_small || shrinks || same) {
      refuse("level {} (dimension {}, cosets {}) must be larger than {}", i, levels[i].dimension,
             levels[i].cosets, i == 0 ? "nothing" : "the level before it");
    }
  }
  const RotationCodeLevel all{static_cast<int>(parts.basis.size()), parts.cosets.size()};
  if (levels.back() != all) {
    refuse("the last level must be the whole code: dimension {}, cosets {}", all.dimension,
           all.cosets);
  }
}

Echelon echelon_of(std::span<const Codeword> basis) {
  Echelon echelon;
  for (std::size_t i = 0; i < basis.size(); ++i) {
    if (!echelon.take(basis[i])) {
      refuse("basis word {} ({}) is a sum of those before it", i, to_hex(basis[i]));
    }
  }
  return echelon;
}

}  // namespace

RotationCode::RotationCode(RotationCodeParts parts) : parts_(std::move(parts)) {
  check_words(parts_);
  check_size(parts_);
  if (parts_.levels.empty()) parts_.levels = {{dimension(), parts_.cosets.size()}};
  check_level_sizes(parts_);
  for (const Codeword coset : parts_.cosets) shifts_.push_back(parts_.translation ^ coset);
  encode_ = LinearMap(parts_.basis);
  number_cosets();
  turn_basis();
  turn_cosets();
  for (const RotationCodeLevel& level : parts_.levels) tags_.push_back(count_tags(level));
}

void RotationCode::number_cosets() {
  const Echelon echelon = echelon_of(parts_.basis);
  std::vector<Codeword> messages;
  for (int bit = 0; bit < bits(); ++bit) {
    messages.push_back(echelon.reduce(Codeword{1} << bit).combination);
  }
  message_ = LinearMap(messages);
  coset_of_rest_.reserve(parts_.cosets.size());
  for (std::size_t i = 0; i < parts_.cosets.size(); ++i) {
    const Echelon::Sum sum = echelon.reduce(parts_.cosets[i]);
    const auto [place, is_new] = coset_of_rest_.insert({sum.rest, {i, sum.combination}});
    if (!is_new) {
      refuse("cosets {} and {} are the same: their difference is a sum of the basis",
             place->second.coset, i);
    }
  }
}

std::optional<RotationCode::Address> RotationCode::find(Codeword word) const {
  const Codeword shifted = word ^ parts_.translation;
  const std::uint64_t message = message_(shifted);
  const auto place = coset_of_rest_.find(shifted ^ encode_(message));
  if (place == coset_of_rest_.end()) return std::nullopt;
  return place->second.coset << dimension() | (message ^ place->second.message);
}

void RotationCode::turn_basis() {
  for (std::size_t i = 0; i < parts_.basis.size(); ++i) {
    const Codeword turned = rotate_quarter(parts_.basis[i], bits());
    const std::uint64_t message = message_(turned);
    const bool inside = encode_(message) == turned;
    for (std::size_t l = 0; l < parts_.levels.size(); ++l) {
      const int dimension = parts_.levels[l].dimension;
      if (static_cast<int>(i) >= dimension || (inside && message <= low_mask(dimension))) continue;
      refuse(
          "level {} is not closed under turns: the turn of basis word {} ({}) is no sum of its "
          "{} basis words",
          l, i, to_hex(parts_.basis[i]), dimension);
    }
    turned_.push_back(message);
  }
  turn_ = LinearMap(turned_);
}

void RotationCode::turn_cosets() {
  for (std::size_t j = 0; j < shifts_.size(); ++j) {
    const std::optional<Address> turned = find(rotate_quarter(shifts_[j], bits()));
    const CosetTurn turn{turned.value_or(0) >> dimension(),
                         turned.value_or(0) & low_mask(dimension())};
    for (std::size_t l = 0; l < parts_.levels.size(); ++l) {
      const RotationCodeLevel& level = parts_.levels[l];
      if (j >= level.cosets ||
          (turned && turn.coset < level.cosets && turn.message <= low_mask(level.dimension))) {
        continue;
      }
      refuse(
          "level {} is not closed under turns: the turn of coset {}, translated ({}), is no "
          "word of it",
          l, j, to_hex(shifts_[j]));
    }
    coset_turns_.push_back(turn);
  }
}

/// A word is fixed by a half turn where its coset c comes back to itself and its message m solves
/// m = H m ^ h: H is the half turn of messages, h that of the coset's first word. The system has
/// no solution or 2^(dimension - rank of H ^ 1).
std::size_t RotationCode::count_tags(const RotationCodeLevel& level) const {
  Echelon differences;  // the columns of H ^ 1
  for (int i = 0; i < level.dimension; ++i) {
    differences.take(turn_(turned_[i]) ^ (std::uint64_t{1} << i));
  }
  const std::uint64_t solutions = std::uint64_t{1} << (level.dimension - differences.rank());
  std::uint64_t fixed = 0;
  for (std::uint64_t coset = 0; coset < level.cosets; ++coset) {
    const Address half = turned(turned(coset << dimension()));
    if (half >> dimension() != coset) continue;
    if (differences.reduce(half & low_mask(dimension())).rest == 0) fixed += solutions;
  }
  return ((std::uint64_t{level.cosets} << level.dimension) - fixed) / 4;
}

}  // namespace tagmint::codec
