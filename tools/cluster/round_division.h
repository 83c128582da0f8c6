#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

namespace tagmint::cluster {

/// A stretch of the pieces of a round: words of the walk, or subtrees.
struct Chunk {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

/// How fast each rank has been at one kind of work, in pieces a second; ranks differ, and codes
/// that are found change it.
class RankSpeeds {
 public:
  explicit RankSpeeds(int ranks) : speeds_(ranks, 0.0) {}

  /// Takes one more measurement of `rank`, in which older ones fade.
  void learn(int rank, std::uint64_t pieces, double seconds);

  /// Speed of `rank`; the mean of the others where it has not worked yet; 0 where none has.
  double of(int rank) const;
  double of_all() const;

 private:
  std::vector<double> speeds_;  // 0 = not known
};

/// Divides one round among the ranks while they work on it: whoever is free takes the next chunk,
/// so that no rank waits for a slow one. Chunks are long enough that handing them out costs
/// nothing and shrink towards the end of the round, where all ranks should be done at once. Safe
/// to call from several threads.
class RoundDivision {
 public:
  /// `speeds` must outlive the object and is updated by it.
  RoundDivision(std::uint64_t first, std::uint64_t count, RankSpeeds& speeds);

  /// The next chunk for `rank`; nothing when all are taken.
  std::optional<Chunk> take(int rank);
  /// `rank` worked so long on a chunk of so many pieces.
  void done(int rank, std::uint64_t pieces, double seconds);
  /// Nobody takes any more.
  void cancel();

 private:
  std::uint64_t chunk_size(int rank) const;

  std::mutex mutex_;
  std::uint64_t next_;
  std::uint64_t left_;
  RankSpeeds& speeds_;
};

}  // namespace tagmint::cluster
