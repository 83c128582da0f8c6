// Figure 5 and 7 of the paper: frontal tags at random places, ever farther away.
#include <fmt/format.h>

#include <cmath>

#include "evaluate/curves.h"
#include "evaluate/experiments/kinds.h"
#include "evaluate/field.h"
#include "evaluate/scenes.h"

namespace tagmint::evaluate {
namespace {

constexpr int kTagsPerPicture = 4;

/// Frontal tags at a series of distances; what is drawn of the table differs.
class FrontalTags : public Experiment {
 public:
  FrontalTags(const Settings& settings, std::vector<double> distances_m, int pictures)
      : settings_(settings),
        distances_m_(std::move(distances_m)),
        pictures_(pictures),
        field_(settings, settings.family, {1, 2}) {}

  std::vector<Column> columns() const override {
    return {{"distance_m", "from the camera's centre to the tag's middle"},
            {"side_px", "of the border square in the middle of the picture"},
            contender_column(),
            decimate_column(),
            {"tags", "shown"},
            {"found", "of them, with the right id in the right place"},
            {"share_found", "found / tags"},
            {"wrong", "reports that are no tag of the picture in its place"},
            {"median_error_m", "median of |estimated - true distance| over the tags found"},
            {"p95_error_m", "95th percentile of the same"},
            {"mean_error_m", "mean of the signed difference: below 0 = seen too near"},
            {"median_error_percent", "median_error_m / distance_m"},
            {"median_corner_px", "median over tags of the root mean square error of the corners"}};
  }

  std::vector<std::string> points() const override {
    std::vector<std::string> names;
    for (const double distance : distances_m_) names.push_back(fmt::format("{} m", distance));
    return names;
  }

  Rows run(std::size_t point, const Work& work) override {
    const double distance = distances_m_[point];
    const std::vector<Tally> tallies = field_.show(
        pictures_,
        [&](int picture) {
          // By the distance, so that both experiments show the same tags at the same distance.
          const auto key = static_cast<std::uint64_t>(std::llround(1000 * distance));
          return frontal_scene(settings_.family, distance, kTagsPerPicture,
                               picture_seed(settings_.seed, key, picture));
        },
        work);
    Rows rows;
    for (std::size_t i = 0; i < tallies.size(); ++i) {
      const Tally& tally = tallies[i];
      const auto error = median(magnitudes(tally.distance_errors_m));
      rows.push_back(
          {distance, kFocal_px * kEdge_m / distance, field_.entrants()[i].contender,
           field_.entrants()[i].decimate, std::int64_t{tally.tags}, std::int64_t{tally.found},
           cell_of(tally.share_found()), std::int64_t{tally.wrong}, cell_of(error),
           cell_of(quantile(magnitudes(tally.distance_errors_m), 0.95)),
           cell_of(mean(tally.distance_errors_m)), error ? Cell(100 * *error / distance) : Cell(),
           cell_of(median(tally.corner_errors_px))});
    }
    return rows;
  }

  std::vector<std::string> conditions() const override {
    return {fmt::format("{} pictures of {} x {} px for each distance, up to {} tags in each; focal "
                        "length {} px, tags of {} m, parallel to the image, any turn",
                        pictures_, kWidth_px, kHeight_px, kTagsPerPicture, kFocal_px, kEdge_m),
            usual_conditions(), family_words(*settings_.family),
            "contenders: " + contestants(settings_)};
  }

 protected:
  const Settings& settings() const { return settings_; }
  const std::vector<Field::Entrant>& entrants() const { return field_.entrants(); }

 private:
  Settings settings_;
  std::vector<double> distances_m_;
  int pictures_;
  Field field_;
};

class Distance : public FrontalTags {
 public:
  explicit Distance(const Settings& settings)
      : FrontalTags(settings, {0.5, 0.75, 1, 1.5, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8, 9, 10, 11},
                    samples_of(settings, 12, 100)) {}

  plot::Figure figure(const Table& table) const override {
    const plot::Axis x{.label = "distance, m", .low = 0};
    const plot::Axis y{.label = "median error of the distance, m", .logarithmic = true};
    return {.title = "Error of the distance by distance (paper, figure 5)",
            .panels = at_both_sizes(table, settings(), x, y, "distance_m", "median_error_m")};
  }

  std::string summary(const Table& table) const override {
    std::vector<std::vector<std::string>> lines = {
        {"median error of the distance at", "2 m", "5 m", "8 m", "10 m"}};
    for (const Field::Entrant& entrant : entrants()) {
      std::vector<std::string>& line = lines.emplace_back();
      line.push_back(fmt::format("  {}, decimate {}", entrant.contender, entrant.decimate));
      for (const double distance : {2.0, 5.0, 8.0, 10.0}) {
        std::string text = "-";
        for (const Row& row : table.rows) {
          const auto error = table.number(row, "median_error_m");
          if (table.word(row, "contender") == entrant.contender && error &&
              table.number(row, "decimate") == entrant.decimate &&
              table.number(row, "distance_m") == distance) {
            text = fmt::format("{:.2f} mm", 1000 * *error);
          }
        }
        line.push_back(std::move(text));
      }
    }
    return aligned(lines);
  }
};

std::vector<double> range_distances_m() {
  std::vector<double> all = {1, 2, 3};
  for (double distance = 3.5; distance <= 14; distance += 0.5) all.push_back(distance);
  return all;
}

class Range : public FrontalTags {
 public:
  explicit Range(const Settings& settings)
      : FrontalTags(settings, range_distances_m(), samples_of(settings, 8, 60)) {}

  plot::Figure figure(const Table& table) const override {
    const plot::Axis x{.label = "distance, m", .low = 0};
    const plot::Axis y{.label = "share of tags found", .low = 0, .high = 1};
    return {.title = "Share of tags found by distance (paper, figure 7)",
            .panels = at_both_sizes(table, settings(), x, y, "distance_m", "share_found")};
  }

  std::string summary(const Table& table) const override {
    std::vector<std::vector<std::string>> lines = {
        {"farthest distance where at least", "99 %", "90 %", "50 %", "are found; side there"}};
    for (const Field::Entrant& entrant : entrants()) {
      std::vector<std::string>& line = lines.emplace_back();
      line.push_back(fmt::format("  {}, decimate {}", entrant.contender, entrant.decimate));
      double side = 0;
      for (const double share : {0.99, 0.9, 0.5}) {
        const double reach = farthest(table, entrant, share);
        line.push_back(reach > 0 ? fmt::format("{} m", reach) : "-");
        if (reach > 0) side = kFocal_px * kEdge_m / reach;
      }
      line.push_back(fmt::format("{:.1f} px", side));
    }
    return aligned(lines);
  }

 private:
  /// The last distance before the first at which fewer are found.
  static double farthest(const Table& table, const Field::Entrant& entrant, double share) {
    double reach = 0;
    for (const Row& row : table.rows) {
      if (table.word(row, "contender") != entrant.contender ||
          table.number(row, "decimate") != entrant.decimate) {
        continue;
      }
      if (table.number(row, "share_found").value_or(0) < share) break;
      reach = table.number(row, "distance_m").value_or(0);
    }
    return reach;
  }
};

}  // namespace

ExperimentKind distance_kind() {
  return {.name = "distance",
          .summary = "error of the distance by distance; paper, figure 5",
          .make = [](const Settings& settings) -> std::unique_ptr<Experiment> {
            return std::make_unique<Distance>(settings);
          }};
}

ExperimentKind range_kind() {
  return {.name = "range",
          .summary = "share of tags found by distance; paper, figure 7",
          .make = [](const Settings& settings) -> std::unique_ptr<Experiment> {
            return std::make_unique<Range>(settings);
          }};
}

}  // namespace tagmint::evaluate
