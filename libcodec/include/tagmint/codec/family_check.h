#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tagmint/codec/family.h"

namespace tagmint::codec {

/// The first place where a family breaks its own word.
struct Violation {
  std::vector<TagId> ids;  ///< the tags concerned, one or two
  std::string message;     ///< one line: what is wrong, with the figures
};

/// What check_family() established.
struct FamilyCheck {
  std::optional<Violation> violation;
  std::vector<std::string>
      proven;  ///< one line for each property that holds, with the figure found
};

/// Proves from the codes alone that all tags are the declared distance apart in every rotation,
/// differ from their own turns by as much, obey the declared complexity rule, occur once, and that
/// each level keeps its own distance. The violation told is the one with the lowest ids. Cost: as
/// family_stats().
FamilyCheck check_family(const Family& family, int threads = 0);

}  // namespace tagmint::codec
