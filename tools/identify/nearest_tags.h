#pragma once

#include <map>
#include <memory>
#include <vector>

#include "tagmint/codec/decoder.h"
#include "tagmint/codec/family.h"

namespace tagmint::identify {

/// The tags of a family that are nearest to a word in any of its four rotations; equally near ones
/// all of them, in order of their ids. Of several turns of one tag that are equally near, the
/// fewest.
///
/// Small families, and those whose tags may be equally near although no cell is wrong, are compared
/// one by one. The others are looked up by codec::Decoder within nearest_miss_radius(), which tells
/// no ties; there are none up to the safe radius. Makes what it needs for a family at the first
/// word, so it serves one caller at a time.
class NearestTags {
 public:
  /// All of them equally near; empty where a family that is looked up has none within the radius.
  ///   cost   four comparisons a tag, or Decoder::decode()
  std::vector<codec::Match> find(const codec::SharedFamily& family, codec::Codeword word);

 private:
  std::map<const codec::Family*, std::unique_ptr<codec::Decoder>> decoders_;
};

}  // namespace tagmint::identify
