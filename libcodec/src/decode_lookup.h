#pragma once

#include <bit>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "four_turns.h"
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

/// A look-up in a list of codewords: an engine finds the nearest one over all turns, whatever turn
/// it is.
class ListLookup : public Decoder::Lookup {
 protected:
  ListLookup(const TagList& tags, int radius) : tags_(tags), radius_(radius) {}

  std::span<const Codeword> codewords() const { return tags_.codewords; }
  int bits() const { return tags_.bits; }

  /// Offers the codeword at `index` if it is within the radius of `word`.
  void compare(Codeword word, std::size_t index, Nearest& nearest) const {
    // Most words that are compared are far away. With software that counts bits, a word with more
    // than two is told faster by taking two away.
    constexpr int kTakenAway = 2;
    const Codeword errors = word ^ codewords()[index];
    const Codeword all_but_one = errors & (errors - 1);
    const Codeword all_but_two = all_but_one & (all_but_one - 1);
    if (all_but_two == 0) {
      const int distance = static_cast<int>(errors != 0) + static_cast<int>(all_but_one != 0);
      if (distance <= radius_) nearest.offer(index, distance);
    } else if (radius_ > kTakenAway) {
      const int distance = std::popcount(errors);
      if (distance <= radius_) nearest.offer(index, distance);
    }
  }

  /// The match of the nearest codeword, unless there is none or a tie: the fewest turns that bring
  /// the observed word so near.
  std::optional<Match> answer(const FourTurns& turned, const Nearest& nearest) const {
    if (!nearest.found() || nearest.tie) return std::nullopt;
    return match_of(turned, nearest);
  }

 private:
  Match match_of(const FourTurns& turned, const Nearest& nearest) const;

  TagList tags_;
  int radius_;
};

/// The reference: compares the word with every codeword.
std::unique_ptr<const Decoder::Lookup> make_brute_force_lookup(const TagList& tags, int radius);

/// All words within `radius` <= 2 of a codeword in a hash table [WangOlson2016, III-E].
std::unique_ptr<const Decoder::Lookup> make_hash_lookup(const TagList& tags, int radius);

/// Bytes that make_hash_lookup()'s table would take.
std::size_t hash_table_bytes(std::size_t codewords, int bits, int radius);

/// Indices by some cells of the word, chosen so that the cells of one have no error.
std::unique_ptr<const Decoder::Lookup> make_chunk_lookup(const TagList& tags, int radius);

/// Looks for the words of one level of a rotation code by information sets, without a list of them.
///   ids   sorted, those to recognise; empty = all of the level. They must outlive the look-up
std::unique_ptr<const Decoder::Lookup> make_information_set_lookup(SharedTagIndex index,
                                                                   std::size_t level,
                                                                   std::span<const TagId> ids,
                                                                   int radius);

}  // namespace tagmint::codec
