#include "tagmint/codec/decoder.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "decode_lookup.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

constexpr int kMostHashErrors = 2;  // the table grows with bits^errors

int checked_errors(const Family& family, const DecoderOptions& options) {
  const int safe = family.max_safe_errors();
  const int errors = options.max_errors.value_or(std::min(2, safe));
  if (errors < 0 || errors > family.bits()) {
    throw std::invalid_argument(fmt::format("{} bit errors cannot be corrected in {}; 0 to {} can",
                                            errors, family.name(),
                                            options.allow_unsafe_radius ? family.bits() : safe));
  }
  if (errors > safe && !options.allow_unsafe_radius) {
    throw std::invalid_argument(
        fmt::format("{} bit errors are more than {} corrects safely; with its distance {}, at most "
                    "{} are, unless an unsafe radius is allowed",
                    errors, family.name(), family.min_hamming(), safe));
  }
  return errors;
}

std::vector<TagId> checked_ids(const Family& family, std::vector<TagId> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  if (!ids.empty() && ids.back() >= family.size()) {
    throw std::invalid_argument(fmt::format("id {} is not in {}, which has ids 0 to {}", ids.back(),
                                            family.name(), family.size() - 1));
  }
  return ids;
}

DecoderEngine chosen_engine(DecoderEngine wanted, std::size_t codewords, int bits, int errors) {
  const bool hash_can = errors <= kMostHashErrors;
  if (wanted == DecoderEngine::Hash && !hash_can) {
    throw std::invalid_argument(fmt::format(
        "the hash table corrects at most {} bit errors, not {}; the chunk index corrects any",
        kMostHashErrors, errors));
  }
  if (wanted != DecoderEngine::Auto) return wanted;
  const bool hash_fits =
      hash_can && hash_table_bytes(codewords, bits, errors) <= Decoder::kMaxTableBytes;
  return hash_fits ? DecoderEngine::Hash : DecoderEngine::Chunks;
}

std::unique_ptr<const Decoder::Lookup> make_lookup(DecoderEngine engine,
                                                   std::span<const Codeword> codewords, int bits,
                                                   int errors) {
  switch (engine) {
    case DecoderEngine::BruteForce:
      return make_brute_force_lookup(codewords, errors);
    case DecoderEngine::Hash:
      return make_hash_lookup(codewords, bits, errors);
    case DecoderEngine::Chunks:
    case DecoderEngine::Auto:
      break;
  }
  return make_chunk_lookup(codewords, bits, errors);
}

}  // namespace

Decoder::Decoder(SharedFamily family, DecoderOptions options) : family_(std::move(family)) {
  if (family_ == nullptr) throw std::invalid_argument("a decoder needs a family, not null");
  max_errors_ = checked_errors(*family_, options);
  chosen_ids_ = checked_ids(*family_, std::move(options.ids));
  for (const TagId id : chosen_ids_) chosen_codewords_.push_back(family_->codeword(id));
  engine_ = chosen_engine(options.engine, codewords().size(), family_->bits(), max_errors_);
  lookup_ = make_lookup(engine_, codewords(), family_->bits(), max_errors_);
}

Decoder::~Decoder() = default;
Decoder::Decoder(Decoder&&) noexcept = default;
Decoder& Decoder::operator=(Decoder&&) noexcept = default;

std::span<const Codeword> Decoder::codewords() const {
  return chosen_ids_.empty() ? family_->codewords() : std::span<const Codeword>(chosen_codewords_);
}

TagId Decoder::id_at(std::size_t index) const {
  return chosen_ids_.empty() ? static_cast<TagId>(index) : chosen_ids_[index];
}

std::optional<Match> Decoder::decode(Codeword observed) const {
  const int bits = family_->bits();
  Nearest best;
  int best_turns = 0;
  for (int turns = 0; turns < 4; ++turns, observed = rotate_quarter(observed, bits)) {
    const Nearest nearest = lookup_->nearest(observed);
    if (!nearest.found() || nearest.distance > best.distance) continue;
    if (nearest.distance < best.distance) {
      best = nearest;
      best_turns = turns;
    } else if (nearest.tie || nearest.index != best.index) {
      best.tie = true;
    }
  }
  if (!best.found() || best.tie) return std::nullopt;
  return Match{id_at(best.index), best.distance, best_turns};
}

std::size_t Decoder::table_bytes() const { return lookup_->table_bytes(); }

std::size_t Decoder::hash_table_bytes(const Family& family, int max_errors) {
  if (max_errors < 0 || max_errors > kMostHashErrors) {
    throw std::invalid_argument(fmt::format("a hash table corrects 0 to {} bit errors, not {}",
                                            kMostHashErrors, max_errors));
  }
  return codec::hash_table_bytes(family.size(), family.bits(), max_errors);
}

}  // namespace tagmint::codec
