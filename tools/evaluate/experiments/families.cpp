// Families side by side: from which size on they are found, and what is taken for their tags.
#include <fmt/format.h>

#include <cmath>

#include "evaluate/curves.h"
#include "evaluate/experiments/kinds.h"
#include "evaluate/family_measures.h"
#include "evaluate/field.h"
#include "evaluate/scenes.h"
#include "tagmint/codec/family_stats.h"

namespace tagmint::evaluate {
namespace {

/// Sides of the whole tag, px.
const std::vector<double> kOuters_px = {10, 12, 14, 16, 18, 20, 22, 25, 28, 32, 40};
constexpr double kEnough = 0.95;

class Families : public Experiment {
 public:
  explicit Families(const Settings& settings)
      : settings_(settings),
        pictures_(samples_of(settings, 1, 6)),
        families_(bundled_families_and(settings.family)) {}

  std::vector<Column> columns() const override {
    return {{"family", "bundled, or the one asked for"},
            contender_column(),
            {"outer_px", "side of the whole tag from the front"},
            {"edge_px", "side of its border square"},
            {"tags", "shown"},
            {"found", "of them, with the right id in the right place"},
            {"share_found", "found / tags"},
            {"wrong", "reports that are no tag of the picture in its place"},
            {"needed_outer_px",
             "of the family and the contender: side of the whole tag from which "
             "95 % are found, between two rows; empty = more than the largest"},
            {"corrected_bits", "of the family: errors that are corrected"},
            {"accept_theory",
             "of the family: share of random words within that many errors of a "
             "tag, four rotations"},
            {"accept_words",
             "of the family: share of random words that its decoder took for a "
             "tag"},
            {"words", "random words that were tried"},
            {"clutter_candidates",
             "of the family and the contender: quads tried in pictures of "
             "clutter without a tag"},
            {"clutter_accepted", "of them, taken for a tag"}};
  }

  std::vector<std::string> points() const override {
    std::vector<std::string> names;
    for (const codec::SharedFamily& family : families_) names.push_back(family->name());
    return names;
  }

  Rows run(std::size_t point, const Work& work) override {
    const codec::SharedFamily& family = families_[point];
    Field field(settings_, family, {1});
    const auto by_size = tallies_by_size(family, field, work);
    const AcceptedWords words = accepted_words(family, settings_.seed, word_count(), work);
    const std::vector<AcceptedQuads> clutter =
        accepted_in_clutter(field, settings_.seed, 4 * pictures_, work);
    const double theory =
        codec::false_accept_rate(family->size(), family->bits(), usual_max_hamming(*family));
    Rows rows;
    for (std::size_t i = 0; i < field.entrants().size(); ++i) {
      const auto needed = needed_outer_px(by_size, i);
      for (std::size_t k = 0; k < kOuters_px.size(); ++k) {
        const Tally& tally = by_size[k][i];
        rows.push_back({family->name(), field.entrants()[i].contender, kOuters_px[k],
                        edge_px(*family, kOuters_px[k]), std::int64_t{tally.tags},
                        std::int64_t{tally.found}, cell_of(tally.share_found()),
                        std::int64_t{tally.wrong}, cell_of(needed),
                        std::int64_t{usual_max_hamming(*family)}, theory,
                        static_cast<double>(words.accepted) / static_cast<double>(words.words),
                        words.words, clutter[i].candidates, clutter[i].accepted});
      }
    }
    return rows;
  }

  plot::Figure figure(const Table& table) const override {
    plot::Axis x{.label = "", .categories = {}};
    for (const codec::SharedFamily& family : families_) x.categories.push_back(family->name());
    plot::Panel sizes{.title = "Size from which 95 % are found",
                      .x = x,
                      .y = {.label = "side of the whole tag, px"},
                      .series = {}};
    plot::Series theory{.label = "4 rotations, theory", .style = 6, .spots = {}, .line = false};
    plot::Series words{.label = "random words, measured", .style = 7, .spots = {}, .line = false};
    for (const ContenderKind& kind : settings_.contenders) {
      plot::Series series{.label = kind.name, .style = kind.style, .spots = {}, .line = false};
      for (const Row& row : table.rows) {
        const auto place = static_cast<double>(place_of(table.word(row, "family")));
        if (table.word(row, "contender") != kind.name ||
            table.number(row, "outer_px") != kOuters_px[0]) {
          continue;
        }
        if (const auto needed = table.number(row, "needed_outer_px")) {
          series.spots.push_back({.x = place, .y = *needed});
        }
        if (kind.name != settings_.contenders[0].name) continue;
        theory.spots.push_back({.x = place, .y = *table.number(row, "accept_theory")});
        const double measured = *table.number(row, "accept_words");
        const double least = 3 / *table.number(row, "words");  // 95 % of none
        words.spots.push_back(
            {.x = place, .y = measured > 0 ? measured : least, .bound = measured == 0});
      }
      sizes.series.push_back(std::move(series));
    }
    plot::Panel accepts{.title = "Random words taken for a tag",
                        .x = x,
                        .y = {.label = "share of words", .logarithmic = true},
                        .series = {theory, words}};
    return {.title = "Families: size that is needed, words that are mistaken",
            .panels = {sizes, accepts},
            .columns = 1};
  }

  std::string summary(const Table& table) const override {
    std::vector<std::vector<std::string>> lines = {{"family", "found from (whole tag)",
                                                    "bits corrected", "accepts, theory",
                                                    "accepts, measured", "in clutter"}};
    for (const Row& row : table.rows) {
      if (table.word(row, "contender") != settings_.contenders[0].name ||
          table.number(row, "outer_px") != kOuters_px[0]) {
        continue;
      }
      const auto needed = table.number(row, "needed_outer_px");
      lines.push_back({"  " + table.word(row, "family"),
                       needed ? fmt::format("{:.1f} px", *needed) : "-",
                       fmt::format("{}", *table.number(row, "corrected_bits")),
                       fmt::format("{:.2g}", *table.number(row, "accept_theory")),
                       fmt::format("{:.2g}", *table.number(row, "accept_words")),
                       fmt::format("{} of {} quads", *table.number(row, "clutter_accepted"),
                                   *table.number(row, "clutter_candidates"))});
    }
    return aligned(lines);
  }

  std::vector<std::string> conditions() const override {
    return {
        fmt::format("{} pictures of {} x {} px for each size, up to 12 tags in each, tilted by "
                    "up to 30 degrees; {} random words a family, {} pictures of clutter",
                    pictures_, kWidth_px, kHeight_px, word_count(), 4 * pictures_),
        usual_conditions(), "contenders: " + contestants(settings_),
        "a contender is left out where it does not know a family or would take too much memory"};
  }

 private:
  std::int64_t word_count() const { return settings_.quick ? 1 << 16 : 1 << 20; }

  std::size_t place_of(const std::string& name) const {
    std::size_t place = 0;
    while (families_[place]->name() != name) ++place;
    return place;
  }

  std::vector<std::vector<Tally>> tallies_by_size(const codec::SharedFamily& family, Field& field,
                                                  const Work& work) const {
    std::vector<std::vector<Tally>> all;
    for (std::size_t k = 0; k < kOuters_px.size(); ++k) {
      all.push_back(field.show(
          pictures_,
          [&](int picture) {
            return sized_scene(family, edge_px(*family, kOuters_px[k]),
                               picture_seed(settings_.seed, k, picture));
          },
          work));
    }
    return all;
  }

  /// Where the share rises above kEnough and stays there.
  static std::optional<double> needed_outer_px(const std::vector<std::vector<Tally>>& by_size,
                                               std::size_t entrant) {
    for (std::size_t k = kOuters_px.size(); k-- > 0;) {
      const double share = by_size[k][entrant].share_found().value_or(0);
      if (share >= kEnough) continue;
      if (k + 1 == kOuters_px.size()) return std::nullopt;
      const double next = by_size[k + 1][entrant].share_found().value_or(0);
      return std::lerp(kOuters_px[k], kOuters_px[k + 1], (kEnough - share) / (next - share));
    }
    return kOuters_px[0];
  }

  Settings settings_;
  int pictures_;
  std::vector<codec::SharedFamily> families_;
};

}  // namespace

ExperimentKind families_kind() {
  return {.name = "families",
          .summary = "size needed and false accepts of each family, and yours",
          .make = [](const Settings& settings) -> std::unique_ptr<Experiment> {
            return std::make_unique<Families>(settings);
          }};
}

}  // namespace tagmint::evaluate
