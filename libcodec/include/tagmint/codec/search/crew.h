#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/complexity.h"
#include "tagmint/codec/export.h"
#include "tagmint/codec/layout.h"
#include "tagmint/codec/search/order.h"

namespace tagmint::codec {

/// What decides the result of a search: all that those who work on it have to agree on.
struct TAGMINT_API SearchRules {
  Layout layout;
  int min_hamming = 0;
  Order order = {};
  Complexity complexity = {};
};

/// A word of the walk that may become a code.
struct TAGMINT_API KeptWord {
  std::uint64_t index = 0;  ///< in the walk; index i is walk position i + 1
  Codeword word = 0;        ///< as a codeword
};

/// What is left of a stretch of the walk.
struct TAGMINT_API SiftedWords {
  std::vector<KeptWord> kept;  ///< ascending by index
  /// Words far enough from the codes and from their own turns; those of them that are complex
  /// enough are kept.
  std::uint64_t distant = 0;
};

/// Those who do the work of a search, which one leader divides into rounds and decides about: the
/// threads of this process (local_crew()), or many processes on many machines. The leader calls
/// from one thread.
class TAGMINT_API SearchCrew {
 public:
  virtual ~SearchCrew() = default;

  /// More codes have been taken; they count from the next round on.
  virtual void learn(std::span<const Codeword> codes) = 0;

  /// The words `first` .. `first + count - 1` of the walk, less those that a code excludes, that
  /// are too near to their own turns, or too plain.
  virtual SiftedWords sift(std::uint64_t first, std::uint64_t count) = 0;

  /// The open tags of the subtrees `first` .. `first + count - 1` of all words: one turn of each
  /// tag that no code excludes and that is far enough from its own turns; in any order.
  ///   first, count   within 0 .. subtree_count(bits)
  virtual std::vector<Codeword> list_open(std::uint64_t first, std::uint64_t count) = 0;

  /// How long a round should take: long beside what it costs to begin and end one, short beside a
  /// user's patience. It may become another when codes are learnt.
  virtual std::chrono::duration<double> round_length() const {
    return std::chrono::milliseconds(200);
  }
};

/// Number of subtrees that the space of all words of so many bits is cut into; bits in 16..63.
TAGMINT_API std::uint64_t subtree_count(int bits);

/// A crew of `threads` threads of this process; 0 = all cores.
///   memory  the codes once a thread; for list_open() the lists of OpenWordTree for each thread
TAGMINT_API std::unique_ptr<SearchCrew> local_crew(const SearchRules& rules, int threads);

using CrewMaker = std::function<std::unique_ptr<SearchCrew>(const SearchRules&, int threads)>;

}  // namespace tagmint::codec
