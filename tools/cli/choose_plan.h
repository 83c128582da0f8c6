#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "tagmint/codec/family.h"

namespace tagmint::cli {

/// What tags are wanted for.
struct TagUse {
  std::size_t tags = 1;    ///< different ids needed, at least 1
  double size_mm = 0;      ///< above 0
  bool outer = false;      ///< size_mm is the side of the whole tag; else that of the border square
  double focal_px = 0;     ///< above 0
  double distance_mm = 0;  ///< above 0
};

/// A family to consider.
struct Candidate {
  std::string source;  ///< how the user names it: a bundled name or the path of its file
  codec::SharedFamily family;
};

/// Ids first .. last.
struct IdRange {
  codec::TagId first = 0;
  codec::TagId last = 0;
  friend bool operator==(const IdRange&, const IdRange&) = default;
};

/// "0-56,60-85", as --ids takes it.
std::string id_list_text(std::span<const IdRange> ranges);

/// How the asked distance compares with the range of a family.
enum class Readability {
  Well,    ///< the range is at least kRangeReserve times as far: tilt and blur may take their share
  Just,    ///< in range, without that reserve
  Beyond,  ///< out of range
};

/// What to know before using a family.
enum class Caution {
  BeyondRange,       ///< fewer than kReliableShare of the tags are read at the asked distance
  LittleReserve,     ///< Readability::Just
  ManyFalseAccepts,  ///< above kAcceptedRate even without correction
  PlainTags,         ///< some of the ids fail the family's complexity rule
  Hole,              ///< the middle is not part of the tag
  CustomLayout,      ///< no other program knows the layout by name
  LargeIds,          ///< ids from 65,535 on, which libapriltag cannot hold
};
inline constexpr int kCautions = 7;

/// Share of tags read that counts as reliable; a family's range is where it still reaches that.
inline constexpr double kReliableShare = 0.95;
/// With half as much range again a tag may be tilted to 48 degrees, or blurred to cells of two
/// thirds.
inline constexpr double kRangeReserve = 1.5;
/// Share of random words that may be taken for a tag: just above the 2.28e-5 of tag36h11 with two
/// corrected bits, the setting most in use.
inline constexpr double kAcceptedRate = 2.5e-5;
/// As many tags as libapriltag can hold.
inline constexpr std::size_t kMostForeignTags = 65535;

/// A family that has enough tags, and how it would serve.
struct FamilyChoice {
  std::string source;
  codec::SharedFamily family;
  std::size_t level = 0;          ///< index of the smallest level that holds the ids
  std::vector<IdRange> ids;       ///< to use
  std::size_t plain_ids = 0;      ///< of them, those that fail the complexity rule
  int min_hamming = 0;            ///< of the ids: that of the level, or more where few are in use
  int safe_errors = 0;            ///< (min_hamming - 1) / 2
  int max_hamming = 0;            ///< errors to correct: the most that are safe and acceptable
  double edge_mm = 0;             ///< side of the border square
  double outer_mm = 0;            ///< side of the whole tag
  double with_quiet_zone_mm = 0;  ///< and with the white around it
  double cell_px = 0;   ///< side of a cell at the asked distance, tag and camera face to face
  double found = 0;     ///< expected share of tags read there
  double range_mm = 0;  ///< how far kReliableShare of them are read
  Readability readability = Readability::Beyond;
  double accepted = 0;          ///< share of random words taken for one of the ids, by max_hamming
  double accepted_at_2 = 0;     ///< with two corrected bits
  double accepted_at_safe = 0;  ///< with all safe ones
  std::vector<std::string> read_by;  ///< other programs that know the tags, "libapriltag"
  std::string known_as;              ///< the published family that has the same tags; or empty
  std::vector<Caution> cautions;
};

/// A family that was left out.
struct TooSmall {
  std::string name;
  std::size_t tags = 0;
};

struct ChoosePlan {
  std::vector<FamilyChoice> ranked;  ///< the best first
  std::vector<TooSmall> too_small;   ///< in the order given
};

/// Ranks families for a use. Each is taken with the smallest of its levels that holds the tags, ids
/// that pass the complexity rule first. Ordered by, in turn:
/// 1. readability at the asked distance; out of range, the range;
/// 2. whether false accepts are acceptable;
/// 3. the share of a tag's cells that may be wrong, max_hamming / bits in whole percent;
/// 4. the share that must be wrong before one tag is taken for another, (min_hamming - max_hamming)
///    / bits in whole percent;
/// 5. the size of the whole tag;
/// 6. whether other programs read it; then the order given.
///   threads   0 = all cores
///   cost      a family that of codec::distance_of_ids()
ChoosePlan choose_families(std::span<const Candidate> candidates, const TagUse& use,
                           int threads = 0);

}  // namespace tagmint::cli
