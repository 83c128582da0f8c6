#include "support/level_family.h"

#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "tagmint/codec/layout_presets.h"

namespace tagmint::test {
namespace {

using codec::RotationCode;

/// Addresses of a level in ascending order: all messages of one coset, then those of the next.
std::vector<RotationCode::Address> addresses(const RotationCode& code,
                                             const codec::RotationCodeLevel& level) {
  std::vector<RotationCode::Address> all;
  for (std::uint64_t coset = 0; coset < level.cosets; ++coset) {
    for (std::uint64_t message = 0; message >> level.dimension == 0; ++message) {
      all.push_back(coset << code.dimension() | message);
    }
  }
  return all;
}

}  // namespace

codec::SharedFamily listed_family(const codec::RotationCodeParts& parts,
                                  std::string_view layout_name, std::span<const int> distances) {
  const RotationCode code(parts);
  codec::FamilyParts family{
      "listed", codec::parse_layout(layout_name), distances.back(), {}, {}, {}, {}};
  std::set<RotationCode::Address> done;  // of smaller levels, and other turns of tags taken
  for (std::size_t level = 0; level < distances.size(); ++level) {
    for (const RotationCode::Address address : addresses(code, code.levels()[level])) {
      if (done.count(address) != 0) continue;
      std::set<RotationCode::Address> orbit;
      for (RotationCode::Address turned = address; orbit.insert(turned).second;) {
        turned = code.turned(turned);
      }
      done.insert(orbit.begin(), orbit.end());
      if (orbit.size() == 4) family.codewords.push_back(code.word(address));
    }
    family.levels.push_back({family.codewords.size(), distances[level]});
  }
  return std::make_shared<const codec::Family>(std::move(family));
}

}  // namespace tagmint::test
