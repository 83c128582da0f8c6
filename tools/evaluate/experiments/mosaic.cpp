// Figures 8 to 10 of the paper: a wall of tags before a camera that moves away from it.
#include <fmt/format.h>

#include <cmath>

#include "evaluate/curves.h"
#include "evaluate/experiments/kinds.h"
#include "evaluate/field.h"
#include "evaluate/scenes.h"
#include "scene/counter_random.h"

namespace tagmint::evaluate {
namespace {

// The paper's camera; it does not tell the lens. At 7 m a tag then has a side of 19 px.
constexpr int kMosaicWidth_px = 1296;
constexpr int kMosaicHeight_px = 964;
constexpr double kMosaicFocal_px = 800;
/// Where the paper's pictures end; ours go on until tags are lost.
constexpr double kPaperFarthest_m = 7;
/// How far the camera's place is from the one that was meant.
constexpr double kShift_m = 0.02;
constexpr double kRoll_deg = 1;

Wall wall_at(double distance_m, std::uint64_t seed) {
  scene::RandomStream random(seed);
  Wall wall;
  wall.width_px = kMosaicWidth_px;
  wall.height_px = kMosaicHeight_px;
  wall.camera = {.fx = kMosaicFocal_px,
                 .fy = kMosaicFocal_px,
                 .cx = kMosaicWidth_px / 2.0,
                 .cy = kMosaicHeight_px / 2.0};
  wall.middle_m = {random.uniform(-kShift_m, kShift_m), random.uniform(-kShift_m, kShift_m),
                   distance_m};
  wall.roll_deg = random.uniform(-kRoll_deg, kRoll_deg);
  return wall;
}

class Mosaic : public Experiment {
 public:
  explicit Mosaic(const Settings& settings)
      : settings_(settings),
        pictures_(samples_of(settings, 2, 12)),
        field_(settings, settings.family, {1, 2}) {}

  std::vector<Column> columns() const override {
    return {{"distance_m", "from the camera to the wall"},
            contender_column(),
            decimate_column(),
            {"tags", "wholly in the pictures"},
            {"found", "of them, with the right id in the right place"},
            {"share_found", "found / tags"},
            {"wrong", "reports that are no tag of the wall in its place"},
            {"centre_found", "pictures in which the wall's middle tag was found"},
            {"centre_mean_error_m", "mean of its estimated less its true distance"},
            {"centre_rms_error_m", "root mean square of the same"},
            {"median_error_m", "median over all tags found of |estimated - true distance|"}};
  }

  std::vector<std::string> points() const override {
    std::vector<std::string> names;
    for (const double distance : kDistances_m) names.push_back(fmt::format("{} m", distance));
    return names;
  }

  Rows run(std::size_t point, const Work& work) override {
    const double distance = kDistances_m[point];
    const auto views = field_.views(
        pictures_,
        [&](int picture) {
          const std::uint64_t seed = picture_seed(settings_.seed, point, picture);
          return wall_scene(settings_.family, wall_at(distance, seed), seed);
        },
        work);
    const Wall wall;
    const auto centre = static_cast<std::size_t>(wall.columns * wall.rows / 2);
    Rows rows;
    for (std::size_t i = 0; i < field_.entrants().size(); ++i) {
      Tally tally;
      std::vector<double> centre_errors, squares;
      for (const std::vector<View>& of_picture : views) {
        tally.add(of_picture[i]);
        for (const Sighting& sighting : of_picture[i].tags) {
          if (sighting.tag != centre || !sighting.distance_error_m) continue;
          centre_errors.push_back(*sighting.distance_error_m);
          squares.push_back(*sighting.distance_error_m * *sighting.distance_error_m);
        }
      }
      const auto square = mean(squares);
      rows.push_back({distance, field_.entrants()[i].contender, field_.entrants()[i].decimate,
                      std::int64_t{tally.tags}, std::int64_t{tally.found},
                      cell_of(tally.share_found()), std::int64_t{tally.wrong},
                      static_cast<std::int64_t>(centre_errors.size()), cell_of(mean(centre_errors)),
                      square ? Cell(std::sqrt(*square)) : Cell(),
                      cell_of(median(magnitudes(tally.distance_errors_m)))});
    }
    return rows;
  }

  plot::Figure figure(const Table& table) const override {
    const plot::Axis x{.label = "distance from the wall, m", .low = 0};
    const plot::Axis y{.label = "error of the centre tag's distance, m", .logarithmic = true};
    const plot::Axis share{.label = "share of tags found", .low = 0, .high = 1};
    plot::Figure figure{.title = "A wall of tags, ever farther away (paper, figures 9 and 10)",
                        .panels = {}};
    figure.panels = at_both_sizes(table, settings_, x, y, "distance_m", "centre_rms_error_m");
    for (plot::Panel& panel :
         at_both_sizes(table, settings_, x, share, "distance_m", "share_found")) {
      panel.marks.push_back(
          {.at = kPaperFarthest_m, .across = false, .text = "the paper's farthest"});
      figure.panels.push_back(std::move(panel));
    }
    return figure;
  }

  std::string summary(const Table& table) const override {
    std::vector<std::vector<std::string>> lines = {
        {"share found, rms error of the centre tag's distance at", "0.6 m", "3 m", "7 m", "10 m"}};
    for (const Field::Entrant& entrant : field_.entrants()) {
      std::vector<std::string>& line = lines.emplace_back();
      line.push_back(fmt::format("  {}, decimate {}", entrant.contender, entrant.decimate));
      for (const Row& row : table.rows) {
        const double distance = table.number(row, "distance_m").value_or(0);
        const bool told = distance == 0.6 || distance == 3 || distance == 7 || distance == 10;
        if (!told || table.word(row, "contender") != entrant.contender ||
            table.number(row, "decimate") != entrant.decimate) {
          continue;
        }
        const auto error = table.number(row, "centre_rms_error_m");
        line.push_back(fmt::format("{:.0f} %, {}",
                                   100 * table.number(row, "share_found").value_or(0),
                                   error ? fmt::format("{:.2g} mm", 1000 * *error) : "-"));
      }
    }
    return aligned(lines);
  }

  std::vector<std::string> conditions() const override {
    const Wall wall;
    return {fmt::format("{} pictures of {} x {} px for each distance, focal length {} px; a wall "
                        "of {} x {} tags of {} m (border square) that touch each other; the camera "
                        "looks at the middle one, up to {} m beside it, rolled by up to {} degree",
                        pictures_, kMosaicWidth_px, kMosaicHeight_px, kMosaicFocal_px, wall.columns,
                        wall.rows, kEdge_m, kShift_m, kRoll_deg),
            usual_conditions(), family_words(*settings_.family),
            "contenders: " + contestants(settings_)};
  }

 private:
  static inline const std::vector<double> kDistances_m = {
      0.6, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5, 5.5, 6, 6.5, 7, 8, 9, 10, 11, 12, 13, 14};
  Settings settings_;
  int pictures_;
  Field field_;
};

}  // namespace

ExperimentKind mosaic_kind() {
  return {.name = "mosaic",
          .summary = "a wall of tags from 0.6 m on; paper, figures 8 to 10",
          .make = [](const Settings& settings) -> std::unique_ptr<Experiment> {
            return std::make_unique<Mosaic>(settings);
          }};
}

}  // namespace tagmint::evaluate
