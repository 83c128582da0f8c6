#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/tag_index.h"

namespace tagmint::codec {

/// The nearest of the codewords offered so far, and whether another one is as near.
struct Nearest {
  static constexpr int kNone = kMaxBits + 1;  // farther than any word can be

  int distance = kNone;
  std::size_t index = 0;
  bool tie = false;

  bool found() const { return distance != kNone; }

  /// Takes one more candidate. The same codeword may be offered several times.
  void offer(std::size_t candidate, int candidate_distance) {
    if (candidate_distance > distance) return;
    if (candidate_distance < distance) {
      *this = {candidate_distance, candidate, false};
    } else if (candidate != index) {
      tie = true;
    }
  }
};

/// Finds the nearest tag to an observed word.
class Decoder::Lookup {
 public:
  virtual ~Lookup() = default;

  /// As Decoder::decode().
  virtual std::optional<Match> decode(Codeword observed) const = 0;

  /// Bytes of the tables beside the codewords themselves.
  virtual std::size_t table_bytes() const = 0;
};

/// Tags by their places in a list. What the spans see must outlive the look-ups made of it.
struct TagList {
  std::span<const Codeword> codewords;
  std::span<const TagId> ids;  ///< by place; empty = the places themselves
  int bits = 0;
};

/// A look-up in a list of codewords, each turn of the observed word by itself.
class ListLookup : public Decoder::Lookup {
 public:
  std::optional<Match> decode(Codeword observed) const override;

 protected:
  ListLookup(const TagList& tags, int radius) : tags_(tags), radius_(radius) {}

  /// The nearest codeword to a word as it stands, if it is within the radius; index = place in the
  /// list. Ties are told, not resolved.
  virtual Nearest nearest(Codeword word) const = 0;

  std::span<const Codeword> codewords() const { return tags_.codewords; }

  /// Offers the codeword at `index` if it is within the radius of `word`.
  void compare(Codeword word, std::size_t index, Nearest& nearest) const {
    const int distance = hamming_distance(word, tags_.codewords[index]);
    if (distance <= radius_) nearest.offer(index, distance);
  }

 private:
  TagList tags_;
  int radius_;
};

/// The reference: compares the word with every codeword.
std::unique_ptr<const Decoder::Lookup> make_brute_force_lookup(const TagList& tags, int radius);

/// All words within `radius` <= 2 of a codeword in a hash table [WangOlson2016, III-E].
std::unique_ptr<const Decoder::Lookup> make_hash_lookup(const TagList& tags, int radius);

/// Bytes that make_hash_lookup()'s table would take.
std::size_t hash_table_bytes(std::size_t codewords, int bits, int radius);

/// An index of `radius` + 1 chunks of the word, one of which has no error.
std::unique_ptr<const Decoder::Lookup> make_chunk_lookup(const TagList& tags, int radius);

/// Looks for the words of one level of a rotation code by information sets, without a list of them.
///   ids   sorted, those to recognise; empty = all of the level. They must outlive the look-up
std::unique_ptr<const Decoder::Lookup> make_information_set_lookup(SharedTagIndex index,
                                                                   std::size_t level,
                                                                   std::span<const TagId> ids,
                                                                   int radius);

}  // namespace tagmint::codec
