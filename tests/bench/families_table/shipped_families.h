#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tagmint/codec/family.h"

namespace tagmint::bench {

/// A family as somebody ships it, or a level of one of ours, and what is said about it.
struct ShippedFamily {
  std::string name;
  codec::Family family;
  std::size_t level = 0;        ///< of the family: its index
  std::optional<int> declared;  ///< distance that its name or its documentation says
  std::optional<int> corrects;  ///< errors that its readers are told to correct
  std::string note;             ///< of its own
};

/// Families of one source; one table.
struct Shipment {
  std::string title;
  std::vector<ShippedFamily> families;
};

/// Everything that can be had here: bundled families with every level of theirs, tag25h7 made again
/// by its search, the dictionaries of the installed OpenCV, older systems by their construction,
/// and the families of `files`, which `tagmint convert` reads.
std::vector<Shipment> shipped_families(const std::vector<std::string>& files);

}  // namespace tagmint::bench
