#include <nlohmann/json.hpp>

#include "cli/identify_report.h"
#include "cli/identify_words.h"

namespace tagmint::cli {
namespace {

using Json = nlohmann::ordered_json;

Json candidate_json(const identify::Candidate& candidate) {
  Json corners = Json::array();
  for (const detect::Point corner : candidate.corners) corners.push_back({corner.x, corner.y});
  Json opencv;
  if (const auto known = opencv_name(candidate)) {
    opencv = {
        {"dictionary", known->dictionary}, {"id", candidate.id}, {"turned_deg", known->turned_deg}};
  }
  return {{"family", candidate.family->name()},
          {"id", candidate.id},
          {"hamming", candidate.hamming},
          {"bits", candidate.family->bits()},
          {"mirrored", candidate.mirrored},
          {"turned_deg", candidate.turned_deg},
          {"inverted", candidate.inverted},
          {"border", border_word(candidate.border)},
          {"quiet_zone", candidate.quiet_zone},
          {"corners", corners},
          {"expected_accidents", candidate.expected_accidents},
          {"opencv4", opencv}};
}

}  // namespace

std::string identify_json(const IdentifyReport& report) {
  Json tags = Json::array();
  for (const identify::TagInPicture& tag : report.found.tags) {
    Json candidates = Json::array();
    for (const identify::Candidate& candidate : tag)
      candidates.push_back(candidate_json(candidate));
    tags.push_back({{"candidates", candidates}});
  }
  const Json all = {
      {"image", report.image},
      {"width", report.width},
      {"height", report.height},
      {"tags", tags},
      {"nearest", report.found.nearest ? candidate_json(*report.found.nearest) : Json()}};
  return all.dump(2) + "\n";
}

}  // namespace tagmint::cli
