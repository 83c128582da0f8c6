#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/family_kinds/family_kind.h"
#include "tagmint/codec/family.h"

namespace tagmint::io {

/// What a reader found in a source of another program.
struct ImportedFamily {
  std::string name;  ///< empty where the source names none
  codec::Layout layout;
  std::optional<int> min_hamming = {};     ///< where the source declares it
  std::vector<codec::Codeword> codewords;  ///< in the layout's order
  std::vector<int> lines;                  ///< of the codewords; empty where there are no lines
  std::string_view kind;                   ///< name of the source's kind
  std::optional<std::string> note = {};    ///< what family_note() once wrote there
};

/// Makes the family: checks the codewords with their lines, takes name and distance from the
/// options, the source or, for the distance, from the codewords themselves, and all else from the
/// note if it belongs to the same codewords and layout.
/// Throws codec::InputError; std::invalid_argument for options that cannot be.
///   cost   without a declared distance O(codewords^2), a nanosecond a pair and thread
ReadFamily make_imported(ImportedFamily parts, const FamilySource& source,
                         const FamilyReadOptions& options);

}  // namespace tagmint::io
