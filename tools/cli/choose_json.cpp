#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/choose_report.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string readability_name(Readability readability) {
  switch (readability) {
    case Readability::Well:
      return "well";
    case Readability::Just:
      return "just";
    case Readability::Beyond:
      return "beyond";
  }
  return {};
}

Json choice_json(const FamilyChoice& choice, const TagUse& use) {
  const codec::Family& family = *choice.family;
  Json warnings = Json::array();
  for (const Caution caution : choice.cautions) warnings.push_back(caution_text(caution, choice));
  Json larger_levels = Json::array();
  for (const codec::Level& level : family.levels().subspan(choice.level + 1)) {
    larger_levels.push_back({{"codes", level.codes}, {"min_hamming", level.min_hamming}});
  }
  return {{"family", family.name()},
          {"source", choice.source},
          {"bits", family.bits()},
          {"layout", codec::layout_name(family.layout())},
          {"codes", family.levels()[choice.level].codes},
          {"min_hamming", choice.min_hamming},
          {"safe_radius", choice.safe_errors},
          {"larger_levels", larger_levels},
          {"ids", id_list_text(choice.ids)},
          {"plain_ids", choice.plain_ids},
          {"max_hamming", choice.max_hamming},
          {"edge_mm", choice.edge_mm},
          {"outer_mm", choice.outer_mm},
          {"with_quiet_zone_mm", choice.with_quiet_zone_mm},
          {"pixels_per_cell", choice.cell_px},
          {"share_read", choice.found},
          {"range_m", choice.range_mm / 1000},
          {"readable", readability_name(choice.readability)},
          {"false_accept_rate",
           {{"at_max_hamming", choice.accepted},
            {"at_2", choice.accepted_at_2},
            {"at_safe_radius", choice.accepted_at_safe}}},
          {"read_by", choice.read_by},
          {"known_as", choice.known_as.empty() ? Json() : Json(choice.known_as)},
          {"warnings", warnings},
          {"print", print_command(choice, use)},
          {"find", find_command(choice)}};
}

}  // namespace

std::string choose_json(const ChoosePlan& plan, const TagUse& use) {
  Json families = Json::array();
  for (const FamilyChoice& choice : plan.ranked) families.push_back(choice_json(choice, use));
  Json too_few = Json::array();
  for (const TooSmall& family : plan.too_small) {
    too_few.push_back({{"family", family.name}, {"codes", family.tags}});
  }
  const Json all = {{"tags", use.tags},
                    {"focal_px", use.focal_px},
                    {"distance_m", use.distance_mm / 1000},
                    {"recommended", families.empty() ? Json() : families.front()["family"]},
                    {"families", families},
                    {"too_few_tags", too_few}};
  return all.dump(2) + "\n";
}

}  // namespace tagmint::cli
