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

std::unique_ptr<const Decoder::Lookup> make_lookup(DecoderEngine engine, const TagList& tags,
                                                   int errors) {
  switch (engine) {
    case DecoderEngine::BruteForce:
      return make_brute_force_lookup(tags, errors);
    case DecoderEngine::Hash:
      return make_hash_lookup(tags, errors);
    case DecoderEngine::Chunks:
    case DecoderEngine::Auto:
      break;
  }
  return make_chunk_lookup(tags, errors);
}

}  // namespace

Decoder::Decoder(SharedFamily family, DecoderOptions options) : family_(std::move(family)) {
  if (family_ == nullptr) throw std::invalid_argument("a decoder needs a family, not null");
  chosen_ids_ = checked_ids(*family_, std::move(options.ids));
  min_hamming_ = distance_of_ids(*family_, chosen_ids_, 1);
  max_errors_ = checked_errors(options);
  for (const TagId id : chosen_ids_) chosen_codewords_.push_back(family_->codeword(id));
  if (chosen_ids_.empty() && !family_->is_listed()) {
    chosen_codewords_ = first_codewords(*family_, family_->size());
  }
  const TagList tags{codewords(), chosen_ids_, family_->bits()};
  engine_ = chosen_engine(options.engine, tags.codewords.size(), tags.bits, max_errors_);
  lookup_ = make_lookup(engine_, tags, max_errors_);
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

std::span<const Codeword> Decoder::codewords() const {
  return chosen_codewords_.empty() ? family_->codewords()
                                   : std::span<const Codeword>(chosen_codewords_);
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
