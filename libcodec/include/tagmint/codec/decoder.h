#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/export.h"
#include "tagmint/codec/family.h"

namespace tagmint::codec {

/// What an observed word was recognised as.
struct TAGMINT_API Match {
  TagId id = 0;
  int hamming = 0;  ///< bit errors between the observed word and the codeword
  int rotation =
      0;  ///< quarter turns (rotate_quarter) that take the observed word to the codeword, 0..3
  friend bool operator==(const Match&, const Match&) = default;
};

/// How a decoder looks words up. All give the same answers.
enum class DecoderEngine {
  /// InformationSets for the codes of a generator, up to the safe radius of the smallest level that
  /// holds the ids, and where there are too many ids to list; else Hash while max_errors <= 2 and
  /// its table has at most kMostHashBytes; else Chunks.
  Auto,
  BruteForce,  ///< compare with every codeword: the reference, no tables
  Hash,  ///< all words within max_errors (at most 2) of a codeword in a hash table [WangOlson2016,
         ///< III-E]
  Chunks,  ///< codewords by some chunks of the word, of which one must be intact: small tables, any
           ///< radius
  InformationSets,  ///< of generated families only: the words of the generator's code near the
                    ///< observed one are found without a list of them, at any radius
};

struct TAGMINT_API DecoderOptions {
  /// Bit errors to correct; nothing = min(2, the safe radius of the ids).
  std::optional<int> max_errors;
  /// Allow max_errors above the safe radius (h - 1) / 2. Then a word equally near to two tags is
  /// refused.
  bool allow_unsafe_radius = false;
  DecoderEngine engine = DecoderEngine::Auto;
  /// Ids to recognise; empty = all.
  std::vector<TagId> ids;
};

/// Codeword -> nearest tag of one family, in any of the four rotations. Constant once made; share
/// it between threads through std::shared_ptr<const Decoder>.
class TAGMINT_API Decoder {
 public:
  /// Largest hash table that DecoderEngine::Auto makes: one that stays in the fastest caches. A
  /// larger one is slower than Chunks (docs/benchmarks.md).
  static constexpr std::size_t kMostHashBytes = std::size_t{64} << 10;

  /// Throws std::invalid_argument when family is null, max_errors is negative, above the safe
  /// radius of the ids without allow_unsafe_radius, above the bits of a word, or above 2 for the
  /// Hash engine, an id is not in the family, or a listed family is to be decoded by information
  /// sets. An id given twice counts once.
  ///   cost   Hash: ids * (words within max_errors) table entries, some 30 million a second;
  ///   Chunks: 8 * ids entries at radius 2, some 20 million a second; for chosen ids that of
  ///   distance_of_ids() on one thread; InformationSets: below a millisecond
  explicit Decoder(SharedFamily family, DecoderOptions options = {});
  ~Decoder();
  Decoder(Decoder&&) noexcept;
  Decoder& operator=(Decoder&&) noexcept;

  /// The tag nearest to `observed` over the four rotations, if it is within max_errors() and no
  /// other tag is as near. Of several turns of the same tag that are equally near, the fewest.
  ///   observed   layout().bits() low bits, the rest zero
  ///   cost       Hash: one table look-up; Chunks: six filtered ones at radius 2, two at 1, one at
  ///   0, 4 * (max_errors + 1) lists above; BruteForce: 4 * ids compares; InformationSets: some
  ///   compares, 26 for 16.8 million words of 48 bits at radius 2, 602 at radius 5 errors     none;
  ///   safe to call from many threads at once
  std::optional<Match> decode(Codeword observed) const;

  const SharedFamily& family() const { return family_; }
  /// Hamming distance of the ids to recognise, as distance_of_ids() gives it: at least that of the
  /// smallest level that holds them, and larger where few ids happen to be farther apart.
  int min_hamming() const { return min_hamming_; }
  /// Bit errors that are always corrected to the right one of the ids to recognise.
  int max_safe_errors() const { return (min_hamming_ - 1) / 2; }
  int max_errors() const { return max_errors_; }
  /// The engine in use, never Auto.
  DecoderEngine engine() const { return engine_; }
  /// Bytes of the look-up tables.
  std::size_t table_bytes() const;

  /// Bytes of the hash table that a decoder for all ids of `family` and `max_errors` (0..2) would
  /// have, without building it. Throws std::invalid_argument for other radii.
  static std::size_t hash_table_bytes(const Family& family, int max_errors);

  /// What decode() asks; implemented by the engines in src/.
  class Lookup;

 private:
  /// Throws as the constructor does.
  int checked_errors(const DecoderOptions& options) const;
  DecoderEngine chosen_engine(DecoderEngine wanted) const;
  /// The smallest level that holds the ids to recognise; an index in family_->levels().
  std::size_t level() const;
  /// How many ids there are to recognise.
  std::size_t id_count() const;
  std::unique_ptr<const Lookup> make_lookup();

  SharedFamily family_;
  int min_hamming_ = 0;
  int max_errors_ = 0;
  DecoderEngine engine_ = DecoderEngine::Auto;
  std::vector<TagId> chosen_ids_;           // sorted; empty = all ids of the family
  std::vector<Codeword> listed_codewords_;  // of those ids, where an engine needs a list that the
                                            // family has not
  std::unique_ptr<const Lookup> lookup_;
};

}  // namespace tagmint::codec
