#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "tagmint/codec/decoder.h"
#include "tagmint/codec/family.h"
#include "tagmint/codec/family_stats.h"

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
  /// "rectangles" where that is the family's rule, else "energy".
  std::string complexity_measure;
  /// Number of tags by the lower end of their complexity: whole rectangles, or colour changes /
  /// (2 * cells) in steps of 0.05.
  std::map<double, std::size_t> complexity_histogram;
  std::vector<LookupMemory> lookup;  ///< for 0 .. the safe radius, as far as an engine goes
};

/// Cost: as codec::family_stats(), and the building of the lookup tables.
FamilyReport make_family_report(codec::SharedFamily family, int threads);

std::string family_report_text(const FamilyReport& report);
std::string family_report_json(const FamilyReport& report);

/// "brute-force", "hash", "chunks", "information-sets".
std::string engine_name(codec::DecoderEngine engine);

}  // namespace tagmint::cli
