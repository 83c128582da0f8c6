#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/family_kinds/family_source.h"

namespace tagmint::io {

/// A value as text, and where it stands.
struct PlacedText {
  std::string text;
  int line = 0;
};

/// Keys and simple values of a JSON or YAML file, as OpenCV writes it: one map, which may stand in
/// a map of its own.
struct FlatKeys {
  std::map<std::string, PlacedText, std::less<>> values;
  std::string title;  ///< key of the map around, or empty
};

/// Reads JSON where the text begins with '{', else the part of YAML that OpenCV writes: `key:
/// value` lines, plain or quoted, with comments. Throws codec::InputError for what is neither, a
/// key that comes twice, and lists or deeper maps.
FlatKeys read_flat_keys(const FamilySource& source);

}  // namespace tagmint::io
