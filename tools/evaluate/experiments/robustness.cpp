// What light and camera may do to a picture before tags are lost.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "evaluate/curves.h"
#include "evaluate/experiments/kinds.h"
#include "evaluate/field.h"
#include "evaluate/jpeg_harm.h"
#include "evaluate/scenes.h"

namespace tagmint::evaluate {
namespace {

/// One kind of harm, ever stronger.
struct Harm {
  std::string name;
  std::string axis;  ///< with its unit
  bool logarithmic;
  std::vector<double> levels;
  void (*apply)(double level, std::uint64_t seed, scene::Scene& scene);
};

constexpr const char* kJpeg = "jpeg";

const std::vector<Harm>& harms() {
  static const std::vector<Harm> all = {
      {"noise",
       "Gaussian noise, gray levels",
       false,
       {0, 5, 10, 15, 20, 30, 40, 50, 60},
       [](double level, std::uint64_t, scene::Scene& scene) { scene.effects.noise_sigma = level; }},
      {"blur",
       "Gaussian blur (sigma), px",
       false,
       {0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 5},
       [](double level, std::uint64_t, scene::Scene& scene) {
         scene.effects.blur_sigma_px = level;
       }},
      {"contrast",
       "white less black, gray levels",
       true,
       {190, 100, 60, 40, 25, 16, 10, 7, 5},
       [](double level, std::uint64_t, scene::Scene& scene) {
         // Clutter of full contrast would hide the tags.
         scene.background = scene::PlainBackground{125};
         scene.effects.black = 125 - level / 2;
         scene.effects.white = 125 + level / 2;
       }},
      {"shadow",
       "light left in a shadow across each tag",
       false,
       {1, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1},
       [](double level, std::uint64_t seed, scene::Scene& scene) {
         shadow_every_tag(level, seed, scene);
       }},
      {"motion",
       "motion of the camera, px",
       false,
       {0, 2, 4, 6, 8, 10, 12, 14, 16},
       [](double level, std::uint64_t seed, scene::Scene& scene) {
         const auto angle = static_cast<double>(seed % 180);
         scene.effects.motion_blur = {.length_px = level, .angle_deg = angle};
       }},
      {kJpeg,
       "JPEG quality",
       false,
       {100, 80, 60, 40, 30, 20, 15, 10, 5},
       [](double, std::uint64_t, scene::Scene&) {}}};  // on the finished picture
  return all;
}

class Robustness : public Experiment {
 public:
  explicit Robustness(const Settings& settings)
      : settings_(settings),
        pictures_(samples_of(settings, 4, 30)),
        field_(settings, settings.family, {1}) {
    for (const Harm& harm : harms()) {
      for (const double level : harm.levels) steps_.emplace_back(&harm, level);
    }
  }

  std::vector<Column> columns() const override {
    return {{"harm", "noise, blur, contrast, shadow, motion or jpeg; all else is as usual"},
            {"level", "gray levels; px; gray levels; share of the light; px; quality"},
            contender_column(),
            {"tags", "shown"},
            {"found", "of them, with the right id in the right place"},
            {"share_found", "found / tags"},
            {"wrong", "reports that are no tag of the picture in its place"},
            {"median_corner_px", "median over tags of the root mean square error of the corners"}};
  }

  std::vector<std::string> points() const override {
    std::vector<std::string> names;
    for (const auto& [harm, level] : steps_) {
      names.push_back(fmt::format("{} {}", harm->name, level));
    }
    return names;
  }

  Rows run(std::size_t point, const Work& work) override {
    const auto [harm, level] = steps_[point];
    Field::Finish finish;
    if (harm->name == kJpeg) {
      finish = [quality = static_cast<int>(level)](const detect::Image& image) {
        return through_jpeg(image, quality);
      };
    }
    const std::vector<Tally> tallies = field_.show(
        pictures_,
        [&, harm = harm, level = level](int picture) {
          // The same tags for every harm.
          const std::uint64_t seed = picture_seed(settings_.seed, 0, picture);
          scene::Scene scene = scattered_scene(settings_.family, {}, seed);
          harm->apply(level, seed, scene);
          return scene;
        },
        work, finish);
    Rows rows;
    for (std::size_t i = 0; i < tallies.size(); ++i) {
      const Tally& tally = tallies[i];
      rows.push_back({harm->name, level, field_.entrants()[i].contender, std::int64_t{tally.tags},
                      std::int64_t{tally.found}, cell_of(tally.share_found()),
                      std::int64_t{tally.wrong}, cell_of(median(tally.corner_errors_px))});
    }
    return rows;
  }

  plot::Figure figure(const Table& table) const override {
    plot::Figure figure{
        .title = "Share of tags found when the picture is harmed", .panels = {}, .columns = 2};
    for (const Harm& harm : harms()) {
      plot::Panel panel{.title = harm.name,
                        .x = {.label = harm.axis, .logarithmic = harm.logarithmic},
                        .y = {.label = "share of tags found", .low = 0, .high = 1},
                        .series = {}};
      panel.series = curves(table, settings_, "level", "share_found",
                            [&](const Row& row) { return table.word(row, "harm") == harm.name; });
      figure.panels.push_back(std::move(panel));
    }
    return figure;
  }

  std::string summary(const Table& table) const override {
    std::vector<std::vector<std::string>> lines = {{"the last level with half of the tags found"}};
    for (const Harm& harm : harms()) lines[0].push_back(harm.name);
    for (const Field::Entrant& entrant : field_.entrants()) {
      std::vector<std::string>& line = lines.emplace_back();
      line.push_back("  " + entrant.contender);
      for (const Harm& harm : harms()) line.push_back(last_level(table, entrant, harm));
    }
    return aligned(lines);
  }

  std::vector<std::string> conditions() const override {
    const Scatter scatter;
    return {fmt::format("{} pictures of {} x {} px for each level, up to {} tags of {} to {} px in "
                        "each, tilted by up to {} degrees, on clutter (contrast: on plain gray); "
                        "the same tags at each level",
                        pictures_, kWidth_px, kHeight_px, scatter.count, scatter.min_side_px,
                        scatter.max_side_px, scatter.max_tilt_deg),
            "but for the harm: gray levels 30 and 220, blur 0.7 px, Gaussian noise 2 gray levels",
            family_words(*settings_.family), "contenders: " + contestants(settings_)};
  }

 private:
  static std::string last_level(const Table& table, const Field::Entrant& entrant,
                                const Harm& harm) {
    std::string last = "-";
    for (const Row& row : table.rows) {
      if (table.word(row, "harm") != harm.name ||
          table.word(row, "contender") != entrant.contender) {
        continue;
      }
      if (table.number(row, "share_found").value_or(0) < 0.5) break;
      last = fmt::format("{}", table.number(row, "level").value_or(0));
    }
    return last;
  }

  Settings settings_;
  int pictures_;
  std::vector<std::pair<const Harm*, double>> steps_;
  Field field_;
};

}  // namespace

ExperimentKind robustness_kind() {
  return {.name = "robustness",
          .summary = "noise, blur, contrast, shadow, motion, JPEG quality",
          .make = [](const Settings& settings) -> std::unique_ptr<Experiment> {
            return std::make_unique<Robustness>(settings);
          }};
}

}  // namespace tagmint::evaluate
