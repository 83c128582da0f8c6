#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/family_kinds/family_source.h"

namespace tagmint::io {

/// A whole number and the line it stands on.
struct PlacedNumber {
  std::int64_t value = 0;
  int line = 0;
};

/// A list of whole numbers: `name[N] = {...}`, `new long[] {...}`, or one `name[i] = ...;` after
/// the other.
struct NumberList {
  std::vector<std::uint64_t> values;  ///< of negative numbers the two's complement
  std::vector<int> lines;             ///< of each value
  std::optional<PlacedNumber> size;   ///< N, where the source says it
  int line = 0;                       ///< where it begins
};

/// What C, C++ or Java source says of a tag family, whatever the program around it does.
struct SourceFacts {
  std::map<std::string, NumberList, std::less<>> lists;     ///< by name; "" = without one
  std::map<std::string, PlacedNumber, std::less<>> fields;  ///< `tf->nbits = 36;`
  std::string name;                        ///< `tf->name = strdup("...")`, else of `..._create`
  std::optional<PlacedNumber> table_bits;  ///< of `TagCodes(36, 11, ...)`, `super(36, 11, ...)`
  std::optional<PlacedNumber> table_distance;
};

/// Collects the facts. Throws codec::InputError for what is no source, a number that cannot be, a
/// list whose items do not follow each other, and a second family in the same file.
SourceFacts collect_source_facts(const FamilySource& source);

}  // namespace tagmint::io
