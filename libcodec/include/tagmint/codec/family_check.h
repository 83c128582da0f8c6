#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tagmint/codec/export.h"
#include "tagmint/codec/family.h"

namespace tagmint::codec {

/// The first place where a family breaks its own word.
struct TAGMINT_API Violation {
  std::vector<TagId> ids;  ///< the tags concerned, one or two; none: the family as a whole
  std::string message;     ///< one line: what is wrong, with the figures
};

/// What check_family() established.
struct TAGMINT_API FamilyCheck {
  std::optional<Violation> violation;
  std::vector<std::string>
      proven;  ///< one line for each property that holds, with the figure found
};

/// Proves from the codes alone that all tags are the declared distance apart in every rotation,
/// differ from their own turns by as much, occur once, that each level keeps its own distance, and
/// that the tags pass the declared complexity rule but for those declared plain, which fail it. Of
/// a generated family the distances are those between the words of its code, and all codewords are
/// made for the other proofs and for the declared digest. The violation told is the one with the
/// lowest ids. Cost: as family_stats(), some 0.3 us more a tag of a generated family.
TAGMINT_API FamilyCheck check_family(const Family& family, int threads = 0);

}  // namespace tagmint::codec
