// One family beside tag36h11.
#include "evaluate/family_trial.h"

#include <fmt/format.h>

#include <algorithm>

#include "evaluate/curves.h"
#include "evaluate/family_measures.h"
#include "evaluate/field.h"
#include "evaluate/scenes.h"
#include "plot/style.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_stats.h"

namespace tagmint::evaluate {
namespace {

/// Side of the whole tag where angle or noise is what changes, px.
constexpr double kOuter_px = 50;

struct Measure {
  const char* name;
  std::vector<double> levels;
};

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all = {
      {kBySize, {10, 11, 12, 13, 14, 15, 16, 18, 20, 22, 25, 30, 40}},
      {kByAngle, {0, 10, 20, 30, 40, 50, 60, 65, 70, 75, 80, 85}},
      {kByNoise, {0, 5, 10, 20, 30, 40, 50, 60, 80}},
      {kWords, {0}},
      {kClutter, {0}}};
  return all;
}

class FamilyTrial : public Experiment {
 public:
  explicit FamilyTrial(const Settings& settings)
      : settings_(settings), pictures_(samples_of(settings, 4, 25)) {
    // The method of the paper is left to the experiments that reproduce it.
    std::erase_if(settings_.contenders,
                  [](const ContenderKind& kind) { return kind.name == "paper's method"; });
    families_ = {settings.family};
    if (settings.family->name() != kYardstickFamily) {
      families_.push_back(codec::find_family(kYardstickFamily));
    }
    for (const codec::SharedFamily& family : families_) {
      fields_.emplace_back(settings_, family, std::vector<double>{1});
      for (const Measure& measure : measures()) {
        for (const double level : measure.levels) {
          steps_.push_back({fields_.size() - 1, measure.name, level});
        }
      }
    }
  }

  std::vector<Column> columns() const override {
    return {{"family", "the one asked for, and tag36h11"},
            {"measure",
             "size, angle, noise: tags found; words: random words taken for tags; "
             "clutter: quads of pictures without tags that were taken for tags"},
            {"level",
             "side of the whole tag, px; off-axis angle, degrees; Gaussian noise, gray "
             "levels; words: bits corrected"},
            contender_column(),
            {"tried", "tags shown; random words; candidate quads"},
            {"hits", "tags found; words or quads taken for tags"},
            {"share", "hits / tried"},
            {"expected", "of words: the share in theory, four rotations"},
            {"wrong", "reports that are no tag of the picture in its place"},
            {"median_corner_px", "median over tags of the root mean square error of the corners"},
            {"median_orientation_deg", "by angle: median orientation error"}};
  }

  std::vector<std::string> points() const override {
    std::vector<std::string> names;
    for (const Step& step : steps_) {
      names.push_back(
          fmt::format("{}, {} {}", families_[step.family]->name(), step.measure, step.level));
    }
    return names;
  }

  Rows run(std::size_t point, const Work& work) override {
    const Step& step = steps_[point];
    const codec::SharedFamily& family = families_[step.family];
    if (step.measure == kWords) return words(family, work);
    Field& field = fields_[step.family];
    if (step.measure == kClutter) return clutter(family, field, work);
    const std::vector<Tally> tallies = field.show(
        pictures_, [&](int picture) { return scene_of(step, picture); }, work);
    Rows rows;
    for (std::size_t i = 0; i < tallies.size(); ++i) {
      const Tally& tally = tallies[i];
      rows.push_back({family->name(), step.measure, step.level, field.entrants()[i].contender,
                      std::int64_t{tally.tags}, std::int64_t{tally.found},
                      cell_of(tally.share_found()), Cell(), std::int64_t{tally.wrong},
                      cell_of(median(tally.corner_errors_px)),
                      cell_of(median(tally.orientation_errors_deg))});
    }
    return rows;
  }

  plot::Figure figure(const Table& table) const override {
    const plot::Axis share{.label = "share of tags found", .low = 0, .high = 1};
    plot::Figure figure{
        .title = fmt::format("{} beside {}", families_[0]->name(), kYardstickFamily), .panels = {}};
    figure.panels.push_back({.title = "by size",
                             .x = {.label = "side of the whole tag, px"},
                             .y = share,
                             .series = series(table, kBySize, "share")});
    figure.panels.push_back({.title = "by angle",
                             .x = {.label = "off-axis angle, degrees", .low = 0, .high = 90},
                             .y = share,
                             .series = series(table, kByAngle, "share")});
    figure.panels.push_back({.title = "by noise",
                             .x = {.label = "Gaussian noise, gray levels", .low = 0},
                             .y = share,
                             .series = series(table, kByNoise, "share")});
    figure.panels.push_back({.title = "orientation by angle",
                             .x = {.label = "off-axis angle, degrees", .low = 0, .high = 90},
                             .y = {.label = "median error, degrees", .logarithmic = true},
                             .series = series(table, kByAngle, "median_orientation_deg")});
    return figure;
  }

  std::string summary(const Table& table) const override {
    std::vector<std::vector<std::string>> lines = {
        {"with tagmint", "90 % from", "90 % up to", "90 % up to noise", "random words taken"}};
    for (const codec::SharedFamily& family : families_) {
      const auto at = [&](const char* measure, bool first) {
        std::optional<double> level;
        for (const Row& row : table.rows) {
          if (table.word(row, "family") != family->name() ||
              table.word(row, "measure") != measure || table.word(row, "contender") != "tagmint") {
            continue;
          }
          const bool enough = table.number(row, "share").value_or(0) >= 0.9;
          if (first && enough && !level) level = table.number(row, "level");
          if (!first && !enough) break;
          if (!first) level = table.number(row, "level");
        }
        return level;
      };
      const auto text = [](const std::optional<double>& level, const char* unit) {
        return level ? fmt::format("{} {}", *level, unit) : std::string("-");
      };
      std::string taken = "-";
      for (const Row& row : table.rows) {
        if (table.word(row, "family") == family->name() && table.word(row, "measure") == kWords) {
          taken = fmt::format("{:.2g} (theory {:.2g})", *table.number(row, "share"),
                              *table.number(row, "expected"));
        }
      }
      lines.push_back({"  " + family->name(), text(at(kBySize, true), "px"),
                       text(at(kByAngle, false), "deg"), text(at(kByNoise, false), "levels"),
                       std::move(taken)});
    }
    return aligned(lines);
  }

  std::vector<std::string> conditions() const override {
    std::vector<std::string> lines = {
        fmt::format("{} pictures of {} x {} px a point; by size and noise up to 12 tags in each, "
                    "tilted by up to 30 degrees; by angle one tag in the middle; whole tags of {} "
                    "px where angle or noise changes",
                    pictures_, kWidth_px, kHeight_px, kOuter_px),
        usual_conditions()};
    for (const codec::SharedFamily& family : families_) lines.push_back(family_words(*family));
    lines.push_back("contenders: " + contestants(settings_));
    return lines;
  }

 private:
  struct Step {
    std::size_t family;
    std::string measure;
    double level;
  };

  scene::Scene scene_of(const Step& step, int picture) const {
    const codec::SharedFamily& family = families_[step.family];
    if (step.measure == kByAngle) {
      const std::uint64_t seed =
          picture_seed(settings_.seed, static_cast<std::uint64_t>(step.level), picture);
      const double distance = kFocal_px * kEdge_m / edge_px(*family, kOuter_px);
      return tilted_scene(family, distance, step.level, seed);
    }
    const std::uint64_t seed = picture_seed(settings_.seed, 1000, picture);
    if (step.measure == kBySize) return sized_scene(family, edge_px(*family, step.level), seed);
    scene::Scene scene = sized_scene(family, edge_px(*family, kOuter_px), seed);
    scene.effects.noise_sigma = step.level;
    return scene;
  }

  Rows words(const codec::SharedFamily& family, const Work& work) const {
    const std::int64_t count = settings_.quick ? 1 << 18 : 1 << 22;
    const AcceptedWords accepted = accepted_words(family, settings_.seed, count, work);
    const int errors = usual_max_hamming(*family);
    return {{family->name(), std::string(kWords), static_cast<double>(errors),
             std::string("tagmint"), accepted.words, accepted.accepted,
             static_cast<double>(accepted.accepted) / static_cast<double>(accepted.words),
             codec::false_accept_rate(family->size(), family->bits(), errors), Cell(), Cell(),
             Cell()}};
  }

  Rows clutter(const codec::SharedFamily& family, Field& field, const Work& work) const {
    const auto sums = accepted_in_clutter(field, settings_.seed, 4 * pictures_, work);
    Rows rows;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      Row row = {family->name(),     std::string(kClutter), 0.0, field.entrants()[i].contender,
                 sums[i].candidates, sums[i].accepted};
      row.resize(columns().size());
      if (sums[i].candidates > 0) {
        row[6] = static_cast<double>(sums[i].accepted) / static_cast<double>(sums[i].candidates);
      }
      rows.push_back(std::move(row));
    }
    return rows;
  }

  std::vector<plot::Series> series(const Table& table, const char* measure,
                                   const char* column) const {
    std::vector<plot::Series> all;
    int style = 0;
    for (const ContenderKind& kind : settings_.contenders) {
      for (const codec::SharedFamily& family : families_) {
        plot::Series one{.label = fmt::format("{}, {}", family->name(), kind.name),
                         .style = style++ % plot::kStyles,
                         .spots = {}};
        for (const Row& row : table.rows) {
          const auto value = table.number(row, column);
          if (value && table.word(row, "family") == family->name() &&
              table.word(row, "contender") == kind.name && table.word(row, "measure") == measure) {
            one.spots.push_back({.x = *table.number(row, "level"), .y = *value});
          }
        }
        if (!one.spots.empty()) all.push_back(std::move(one));
      }
    }
    return all;
  }

  Settings settings_;
  int pictures_;
  std::vector<codec::SharedFamily> families_;
  std::vector<Field> fields_;
  std::vector<Step> steps_;
};

}  // namespace

ExperimentKind family_trial_kind() {
  return {.name = "family",
          .summary = "a family by size, angle and noise, and mistaken, beside tag36h11",
          .make = [](const Settings& settings) -> std::unique_ptr<Experiment> {
            return std::make_unique<FamilyTrial>(settings);
          }};
}

}  // namespace tagmint::evaluate
