#include "tagmint/codec/decoder.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "decode_lookup.h"
#include "tagmint/codec/id_distance.h"

namespace tagmint::codec {
namespace {

constexpr int kMostHashErrors = 2;  // the table grows with bits^errors

}  // namespace

Decoder::Decoder(SharedFamily family, DecoderOptions options) : family_(std::move(family)) {
  if (family_ == nullptr) throw std::invalid_argument("a decoder needs a family, not null");
  chosen_ids_ = ascending_ids(std::move(options.ids));
  min_hamming_ = distance_of_ids(*family_, chosen_ids_, 1);
  max_errors_ = checked_errors(options);
  engine_ = chosen_engine(options.engine);
  lookup_ = make_lookup();
}

Decoder::~Decoder() = default;
Decoder::Decoder(Decoder&&) noexcept = default;
Decoder& Decoder::operator=(Decoder&&) noexcept = default;

int Decoder::checked_errors(const DecoderOptions& options) const {
  const int safe = max_safe_errors();
  const int bits = family_->bits();
  const int errors = options.max_errors.value_or(std::min(2, safe));
  if (errors < 0 || errors > bits) {
    throw std::invalid_argument(fmt::format("{} bit errors cannot be corrected in {}; 0 to {} can",
                                            errors, family_->name(),
                                            options.allow_unsafe_radius ? bits : safe));
  }
  if (errors > safe && !options.allow_unsafe_radius) {
    throw std::invalid_argument(fmt::format(
        "{} bit errors are more than {} corrects safely; with {} distance {}, at most {} are, "
        "unless an unsafe radius is allowed",
        errors, family_->name(), chosen_ids_.empty() ? "its" : "the chosen ids'", min_hamming_,
        safe));
  }
  return errors;
}

std::size_t Decoder::id_count() const {
  return chosen_ids_.empty() ? family_->size() : chosen_ids_.size();
}

std::size_t Decoder::level() const {
  return chosen_ids_.empty() ? family_->levels().size() - 1
                             : level_of_id(*family_, chosen_ids_.back());
}

DecoderEngine Decoder::chosen_engine(DecoderEngine wanted) const {
  const bool hash_can = max_errors_ <= kMostHashErrors;
  if (wanted == DecoderEngine::Hash && !hash_can) {
    throw std::invalid_argument(fmt::format(
        "the hash table corrects at most {} bit errors, not {}; the chunk index corrects any",
        kMostHashErrors, max_errors_));
  }
  if (wanted == DecoderEngine::InformationSets && family_->is_listed()) {
    throw std::invalid_argument(fmt::format(
        "{} lists its codewords; information sets decode families that have a generator",
        family_->name()));
  }
  if (wanted != DecoderEngine::Auto) return wanted;
  // A few ids of a level may be far apart. Beyond the level's own safe radius its other tags would
  // be found again and again.
  const Level& held_by = family_->levels()[level()];
  const bool few = id_count() < held_by.codes && id_count() <= kMostComparedIds;
  if (!family_->is_listed() && !(few && max_errors_ > (held_by.min_hamming - 1) / 2)) {
    return DecoderEngine::InformationSets;
  }
  const bool hash_fits = hash_can && codec::hash_table_bytes(id_count(), family_->bits(),
                                                             max_errors_) <= kMostHashBytes;
  return hash_fits ? DecoderEngine::Hash : DecoderEngine::Chunks;
}

std::unique_ptr<const Decoder::Lookup> Decoder::make_lookup() {
  if (engine_ == DecoderEngine::InformationSets) {
    const bool whole_level = id_count() == family_->levels()[level()].codes;
    if (whole_level) return make_information_set_lookup(family_->index(), level(), {}, max_errors_);
    return make_information_set_lookup(family_->index(), level(), chosen_ids_, max_errors_);
  }
  for (const TagId id : chosen_ids_) listed_codewords_.push_back(family_->codeword(id));
  if (chosen_ids_.empty() && !family_->is_listed()) {
    listed_codewords_ = first_codewords(*family_, family_->size());
  }
  const TagList tags{listed_codewords_.empty() ? family_->codewords() : listed_codewords_,
                     chosen_ids_, family_->bits()};
  switch (engine_) {
    case DecoderEngine::BruteForce:
      return make_brute_force_lookup(tags, max_errors_);
    case DecoderEngine::Hash:
      return make_hash_lookup(tags, max_errors_);
    default:
      return make_chunk_lookup(tags, max_errors_);
  }
}

std::optional<Match> Decoder::decode(Codeword observed) const { return lookup_->decode(observed); }

std::size_t Decoder::table_bytes() const { return lookup_->table_bytes(); }

std::size_t Decoder::hash_table_bytes(const Family& family, int max_errors) {
  if (max_errors < 0 || max_errors > kMostHashErrors) {
    throw std::invalid_argument(fmt::format("a hash table corrects 0 to {} bit errors, not {}",
                                            kMostHashErrors, max_errors));
  }
  return codec::hash_table_bytes(family.size(), family.bits(), max_errors);
}

}  // namespace tagmint::codec
