// Figure 6 of the paper: one tag on the optical axis, ever more oblique.
#include <fmt/format.h>

#include "evaluate/curves.h"
#include "evaluate/experiments/kinds.h"
#include "evaluate/field.h"
#include "evaluate/scenes.h"

namespace tagmint::evaluate {
namespace {

/// The tag's side is 60 px when it faces the camera.
constexpr double kDistance_m = 1.67;
constexpr double kStep_deg = 5;
constexpr double kMost_deg = 85;

class Angle : public Experiment {
 public:
  explicit Angle(const Settings& settings)
      : settings_(settings),
        pictures_(samples_of(settings, 30, 200)),
        field_(settings, settings.family, {1, 2}) {
    for (double angle = 0; angle <= kMost_deg; angle += kStep_deg) angles_deg_.push_back(angle);
  }

  std::vector<Column> columns() const override {
    return {{"angle_deg", "between the tag's normal and the optical axis"},
            contender_column(),
            decimate_column(),
            {"tags", "shown"},
            {"found", "of them, with the right id in the right place"},
            {"share_found", "found / tags"},
            {"median_error_deg",
             "median over the tags found of the angle of the rotation between "
             "estimated and true orientation"},
            {"p95_error_deg", "95th percentile of the same"},
            {"mean_error_deg", "mean of the same"},
            {"median_corner_px", "median over tags of the root mean square error of the corners"}};
  }

  std::vector<std::string> points() const override {
    std::vector<std::string> names;
    for (const double angle : angles_deg_) names.push_back(fmt::format("{} degrees", angle));
    return names;
  }

  Rows run(std::size_t point, const Work& work) override {
    const double angle = angles_deg_[point];
    const std::vector<Tally> tallies = field_.show(
        pictures_,
        [&](int picture) {
          return tilted_scene(settings_.family, kDistance_m, angle,
                              picture_seed(settings_.seed, point, picture));
        },
        work);
    Rows rows;
    for (std::size_t i = 0; i < tallies.size(); ++i) {
      const Tally& tally = tallies[i];
      rows.push_back({angle, field_.entrants()[i].contender, field_.entrants()[i].decimate,
                      std::int64_t{tally.tags}, std::int64_t{tally.found},
                      cell_of(tally.share_found()), cell_of(median(tally.orientation_errors_deg)),
                      cell_of(quantile(tally.orientation_errors_deg, 0.95)),
                      cell_of(mean(tally.orientation_errors_deg)),
                      cell_of(median(tally.corner_errors_px))});
    }
    return rows;
  }

  plot::Figure figure(const Table& table) const override {
    const plot::Axis x{.label = "off-axis angle, degrees", .low = 0, .high = 90};
    const plot::Axis y{.label = "median orientation error, degrees", .logarithmic = true};
    const plot::Axis share{.label = "share of tags found", .low = 0, .high = 1};
    plot::Figure figure{.title = "Orientation error by off-axis angle (paper, figure 6)",
                        .panels = {}};
    figure.panels = at_both_sizes(table, settings_, x, y, "angle_deg", "median_error_deg");
    for (plot::Panel& panel :
         at_both_sizes(table, settings_, x, share, "angle_deg", "share_found")) {
      figure.panels.push_back(std::move(panel));
    }
    return figure;
  }

  std::string summary(const Table& table) const override {
    std::vector<std::vector<std::string>> lines = {
        {"median orientation error (share found) at", "0 deg", "40 deg", "70 deg", "80 deg"}};
    for (const Field::Entrant& entrant : field_.entrants()) {
      std::vector<std::string>& line = lines.emplace_back();
      line.push_back(fmt::format("  {}, decimate {}", entrant.contender, entrant.decimate));
      for (const double angle : {0.0, 40.0, 70.0, 80.0}) {
        for (const Row& row : table.rows) {
          if (table.word(row, "contender") != entrant.contender ||
              table.number(row, "decimate") != entrant.decimate ||
              table.number(row, "angle_deg") != angle) {
            continue;
          }
          const auto error = table.number(row, "median_error_deg");
          const double share = table.number(row, "share_found").value_or(0);
          line.push_back(error ? fmt::format("{:.3f} ({:.0f} %)", *error, 100 * share) : "-");
        }
      }
    }
    return aligned(lines);
  }

  std::vector<std::string> conditions() const override {
    return {fmt::format("{} pictures of {} x {} px for each angle, a tag in the middle of each, "
                        "{} m away; focal length {} px, tags of {} m: {:.0f} px when frontal",
                        pictures_, kWidth_px, kHeight_px, kDistance_m, kFocal_px, kEdge_m,
                        kFocal_px * kEdge_m / kDistance_m),
            usual_conditions(), family_words(*settings_.family),
            "contenders: " + contestants(settings_)};
  }

 private:
  Settings settings_;
  int pictures_;
  std::vector<double> angles_deg_;
  Field field_;
};

}  // namespace

ExperimentKind angle_kind() {
  return {.name = "angle",
          .summary = "orientation error by off-axis angle; paper, figure 6",
          .make = [](const Settings& settings) -> std::unique_ptr<Experiment> {
            return std::make_unique<Angle>(settings);
          }};
}

}  // namespace tagmint::evaluate
