#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "families_table/shipped_families.h"

namespace tagmint::bench {

/// What the codewords of a family (or of one of its levels) say.
struct FamilyRow {
  const ShippedFamily* shipped = nullptr;
  std::size_t codes = 0;
  int between = 0;  ///< least distance of two tags in any rotation
  int self = 0;     ///< least distance of a tag to one of its own turns
  /// Errors that are always corrected to the right tag in the right turn; nothing where even a
  /// faultless reading is ambiguous.
  std::optional<int> safe_radius;
  std::string alike;  ///< the nearest pairs and, where a tag equals a turn of itself, those tags
  std::vector<std::string> notes;

  /// Share of random words taken for a tag with so many errors corrected.
  double false_accepts(int errors) const;
};

/// The row of a family; `earlier` are those that it may be a copy of.
///   cost   O(codes^2) for listed codewords, and for levels of up to 20,000 generated ones
FamilyRow family_row(const ShippedFamily& shipped, const std::vector<FamilyRow>& earlier);

/// Rows as a table of markdown.
std::string as_markdown(const std::vector<FamilyRow>& rows);

}  // namespace tagmint::bench
