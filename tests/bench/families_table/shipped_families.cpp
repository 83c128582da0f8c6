#include "families_table/shipped_families.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "io/family_kinds/family_kind.h"
#include "io/family_kinds/older_systems.h"
#include "support/opencv_dictionaries.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/search/lexicode.h"

namespace tagmint::bench {
namespace {

/// "tag36h11" -> 11: what stands behind the last h.
std::optional<int> distance_in_name(const std::string& name) {
  const std::size_t h = name.rfind('h');
  int distance = 0;
  if (h == std::string::npos) return std::nullopt;
  const auto [end, error] =
      std::from_chars(name.data() + h + 1, name.data() + name.size(), distance);
  return error == std::errc() ? std::optional(distance) : std::nullopt;
}

/// Every level of a bundled family as a row.
void add_levels(const std::string& name, std::vector<ShippedFamily>& families) {
  const codec::Family& family = *codec::find_family(name);
  for (std::size_t level = 0; level < family.levels().size(); ++level) {
    const bool whole = level + 1 == family.levels().size();
    families.push_back(
        {.name = whole ? name : fmt::format("{}, ids 0-{}", name, family.levels()[level].codes - 1),
         .family = family,
         .level = level,
         .declared = family.levels()[level].min_hamming,
         .corrects = {},
         .note = {}});
  }
}

/// An AprilTag 2 family that libapriltag dropped, as its published search finds it.
ShippedFamily tag25h7() {
  const codec::Layout layout = codec::classic_layout(9);
  constexpr int kDistance = 7;
  const codec::LexicodeOptions options{.layout = layout,
                                       .min_hamming = kDistance,
                                       .order = codec::parse_order("apriltag2"),
                                       .complexity = {codec::ComplexityRule::Rectangles, 8}};
  return {.name = "tag25h7",
          .family = codec::make_family(options, codec::search_lexicode(options), "tag25h7"),
          .declared = kDistance,
          .corrects = {},
          .note = "not in libapriltag 3; made again by its search"};
}

struct OlderSystemFacts {
  const char* name;
  std::optional<int> declared;
  const char* note;
};

/// What the construction of a code promises, turns not considered.
std::vector<OlderSystemFacts> older_system_facts() {
  return {{"artoolkitplus-bch", 9, "BCH code of designed distance 9, turns not considered"},
          {"artoolkit-4x4-bch-13-9-3", 3, "three corners tell the turn, unchecked"},
          {"artoolkit-4x4-bch-13-5-5", 5, "three corners tell the turn, unchecked"},
          {"artoolkit-4x4", 1, "three corners tell the turn, unchecked"}};
}

ShippedFamily older_system(const std::string& name) {
  ShippedFamily shipped{.name = name,
                        .family = io::find_older_system(name, {})->family,
                        .declared = {},
                        .corrects = {},
                        .note = {}};
  for (const OlderSystemFacts& facts : older_system_facts()) {
    if (facts.name != name) continue;
    shipped.declared = facts.declared;
    shipped.note = facts.note;
  }
  return shipped;
}

ShippedFamily from_file(const std::string& file) {
  const io::FamilySource source = io::read_family_source(file);
  codec::Family family = io::recognise_family_kind(source).read(source, {}).family;
  const std::string name = family.name();
  return {.name = name,
          .family = std::move(family),
          .declared = distance_in_name(name),
          .corrects = {},
          .note = {}};
}

}  // namespace

std::vector<Shipment> shipped_families(const std::vector<std::string>& files) {
  Shipment published{"AprilTag: libapriltag's families and older ones", {}};
  Shipment completed{"AprilTag's searches completed", {}};
  Shipment rotation{"Rotation codes", {}};
  for (const std::string& name : codec::family_names()) {
    const bool ours = codec::find_family(name)->origin().method != "lexicode";
    Shipment& shipment = ours ? rotation : name.ends_with('x') ? completed : published;
    add_levels(name, shipment.families);
  }
  published.families.push_back(tag25h7());

  Shipment opencv{"OpenCV's predefined dictionaries", {}};
  for (test::OpenCvDictionary& dictionary : test::opencv_dictionaries()) {
    opencv.families.push_back({.name = dictionary.name,
                               .family = std::move(dictionary.family),
                               .declared = dictionary.declared,
                               .corrects = dictionary.corrects,
                               .note = {}});
  }

  Shipment older{"Older systems, by their construction", {}};
  for (const std::string& name : io::older_system_names()) {
    older.families.push_back(older_system(name));
  }

  std::vector<Shipment> all = {std::move(published), std::move(opencv), std::move(older)};
  if (!files.empty()) {
    Shipment read{"Dictionaries of the ArUco library, from files", {}};
    for (const std::string& file : files) read.families.push_back(from_file(file));
    all.push_back(std::move(read));
  }
  all.push_back(std::move(completed));
  all.push_back(std::move(rotation));
  return all;
}

}  // namespace tagmint::bench
