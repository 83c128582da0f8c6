#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/family_report.h"
#include "cli/family_text.h"
#include "tagmint/codec/complexity.h"

namespace tagmint::cli {
namespace {

using Json = nlohmann::ordered_json;

/// The distances that occur: [{"distance":11,"<counted>":208},...].
template <typename Count>
Json histogram_json(const std::vector<Count>& histogram, const std::string& counted) {
  Json bars = Json::array();
  for (std::size_t distance = 0; distance < histogram.size(); ++distance) {
    if (histogram[distance] == 0) continue;
    bars.push_back({{"distance", distance}, {counted, histogram[distance]}});
  }
  return bars;
}

Json rate_json(std::size_t codes, int bits, int errors) {
  return {{"corrected_bits", errors}, {"rate", codec::false_accept_rate(codes, bits, errors)}};
}

/// Adds what was found to the levels of family_summary_json().
void add_levels(const FamilyReport& report, Json& levels) {
  const int bits = report.family->bits();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const codec::LevelStats& found = report.stats.levels[i];
    const int safe = (report.family->levels()[i].min_hamming - 1) / 2;
    levels[i]["true_min_hamming"] = found.min_hamming;
    levels[i]["safe_radius"] = safe;
    levels[i]["passing"] = found.passing;
    Json rates = Json::array();
    for (int errors = 0; errors <= std::max(safe, std::min(2, bits)); ++errors) {
      rates.push_back(rate_json(found.codes, bits, errors));
    }
    levels[i]["false_accept_rate"] = rates;
  }
}

}  // namespace

std::string family_report_json(const FamilyReport& report) {
  const codec::Family& family = *report.family;
  Json json = family_summary_json(family);
  json["true_min_hamming"] = report.stats.min_hamming;
  const auto safe = report.safe_errors();
  json["safe_radius"] = safe ? Json(*safe) : Json(nullptr);
  json["distance_between_tags"] = report.between ? Json(*report.between) : Json(nullptr);
  json["self_distance"] = report.self_distance;
  json["nearest_pairs"] = Json::array();
  for (const codec::NearPair& pair : report.nearest) {
    json["nearest_pairs"].push_back(
        {{"ids", {pair.first, pair.second}}, {"distance", pair.distance}, {"turns", pair.turns}});
  }
  json["layout_rows"] = family.layout().rows();
  json["reversed_border"] = family.layout().reversed_border();
  json["complexity"] = codec::to_string(family.complexity());
  const codec::Origin& origin = family.origin();
  json["origin"] = {{"method", origin.method},
                    {"order", origin.order},
                    {"seed", origin.seed},
                    {"searched", origin.searched},
                    {"program", origin.program}};
  json["sha256"] = report.digest;
  add_levels(report, json["levels"]);
  if (family.is_listed()) {
    json["distance_histogram"] = histogram_json(report.stats.distance_histogram, "pairs");
  } else {
    json["word_distances"] = histogram_json(report.stats.word_distances, "words");
  }
  json["self_distance_histogram"] = histogram_json(report.stats.self_histogram, "tags");
  json["false_accept_rate"] = Json::array();
  for (std::size_t bits = 0; bits < report.stats.false_accept_rate.size(); ++bits) {
    json["false_accept_rate"].push_back(
        rate_json(family.size(), family.bits(), static_cast<int>(bits)));
  }
  json["complexity_histogram"] = Json::array();
  for (const auto& [value, tags] : report.complexity_histogram) {
    json["complexity_histogram"].push_back({{report.complexity_measure, value}, {"tags", tags}});
  }
  json["lookup"] = Json::array();
  for (const LookupMemory& memory : report.lookup) {
    json["lookup"].push_back({{"engine", engine_name(memory.engine)},
                              {"max_errors", memory.max_errors},
                              {"bytes", memory.bytes}});
  }
  return json.dump(2) + "\n";
}

}  // namespace tagmint::cli
