#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tagmint/codec/decoder.h"
#include "tagmint/codec/family.h"
#include "tagmint/codec/family_stats.h"
#include "tagmint/codec/near_pairs.h"

namespace tagmint::cli {

/// Memory of one way to look codewords up.
struct LookupMemory {
  codec::DecoderEngine engine = codec::DecoderEngine::BruteForce;
  int max_errors = 0;     ///< corrected bit errors
  std::size_t bytes = 0;  ///< of the tables
};

/// Everything that `tagmint info` tells about a family.
struct FamilyReport {
  codec::SharedFamily family;
  std::string digest;  ///< SHA-256 over the codewords; as declared where they are generated
  codec::FamilyStats stats;
  /// Least distance of two tags in any rotation; nothing for one tag alone, and for generated
  /// families, whose words are counted instead (FamilyStats::word_distances).
  std::optional<int> between;
  int self_distance = 0;                 ///< least distance of a tag to its own turns
  std::vector<codec::NearPair> nearest;  ///< the first pairs that are no more than `between` apart
  /// "rectangles" where that is the family's rule, else "energy".
  std::string complexity_measure;
  /// Number of tags by the lower end of their complexity: whole rectangles, or colour changes /
  /// (2 * cells) in steps of kEnergyStep.
  std::map<double, std::size_t> complexity_histogram;
  std::vector<LookupMemory> lookup;  ///< for 0 .. the safe radius, as far as an engine goes

  /// Errors that are always corrected, by the declared distance or the true one, whichever is less;
  /// nothing where even a faultless reading may be two tags or two turns.
  std::optional<int> safe_errors() const;
};

inline constexpr double kEnergyStep = 0.05;

/// Cost: as codec::family_stats(), and the building of the lookup tables.
FamilyReport make_family_report(codec::SharedFamily family, int threads);

std::string family_report_text(const FamilyReport& report);
std::string family_report_json(const FamilyReport& report);

/// "brute-force", "hash", "chunks", "information-sets".
std::string engine_name(codec::DecoderEngine engine);

/// "lexicode, order apriltag2, seed 361110, searched complete, by ..."; "not known".
std::string origin_text(const codec::Origin& origin);

/// The complexity rule, and how many tags pass it where not all do.
std::string complexity_text(const FamilyReport& report);

/// The nearest tags by their ids: "0 and 5, 0 and 13, ... of 156 pairs".
std::string nearest_text(const FamilyReport& report);

}  // namespace tagmint::cli
