// Table I of the paper: what is taken for a tag where there is none.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include "evaluate/curves.h"
#include "evaluate/experiments/kinds.h"
#include "evaluate/field.h"
#include "evaluate/photographs.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/family_stats.h"

namespace tagmint::evaluate {
namespace {

constexpr std::size_t kFilesPerPoint = 4;
constexpr int kMostErrors = 2;
/// Quick runs take so many files, spread over all, in sizes up to this.
constexpr std::size_t kQuickFiles = 12;
constexpr double kQuickMegapixels = 2.5;

/// What an entrant made of some pictures.
struct Counts {
  std::int64_t candidates = 0;
  std::array<std::int64_t, kMostErrors + 1> by_errors{};
  std::int64_t accepted = 0;
  bool says_candidates = true;
  bool says_errors = true;
};

class FalsePositives : public Experiment {
 public:
  explicit FalsePositives(const Settings& settings) : settings_(settings) {
    if (settings.photographs.empty()) {
      throw codec::InputError("there are no photographs", "--photographs",
                              "name a folder of pictures without tags; tools/fetch_photographs.sh "
                              "makes one");
    }
    files_ = chosen_files();
    std::vector<codec::SharedFamily> families = {settings.family};
    if (!settings.own_family) {
      families = {codec::find_family("tag36h11"), codec::find_family("tag25h9"),
                  codec::find_family("tag16h5")};
    }
    for (const codec::SharedFamily& family : families) {
      fields_.push_back({family, Field(settings, family, {1})});
    }
  }

  std::vector<Column> columns() const override {
    return {{"family", "looked for"},
            contender_column(),
            {"pictures", "files"},
            {"images", "pictures at full size and halved down to 500 px"},
            {"megapixels", "of all images"},
            {"candidates", "quads that were tried; of OpenCV, its candidates"},
            {"errors", "bits that were corrected in what follows; all = all together"},
            {"accepted", "tags reported with so many errors: all of them false"},
            {"rate", "accepted / candidates"},
            {"theory_1",
             "share of random words with so many errors from a tag in one rotation, as "
             "the paper counts"},
            {"theory_4", "the same in any of the four rotations, as tags are found"},
            {"accepted_per_megapixel", "accepted / megapixels"}};
  }

  std::vector<std::string> points() const override {
    std::vector<std::string> names;
    for (std::size_t first = 0; first < files_.size(); first += kFilesPerPoint) {
      names.push_back(fmt::format("files from {}", first));
    }
    return names;
  }

  /// Rows of a point: family, contender, pictures, images, pixels, candidates, by errors, accepted.
  Rows run(std::size_t point, const Work& work) override {
    const std::size_t first = point * kFilesPerPoint;
    const std::size_t count = std::min(kFilesPerPoint, files_.size() - first);
    std::vector<std::vector<Counts>> by_file(count, std::vector<Counts>(entrants()));
    std::vector<std::int64_t> images(count), pixels(count);
    work.for_each(static_cast<int>(count), [&](int file, int thread) {
      const auto f = static_cast<std::size_t>(file);
      for_each_size(files_[first + f], [&](const detect::Image& image) {
        if (settings_.quick && 1e-6 * image.width() * image.height() > kQuickMegapixels) return;
        ++images[f];
        pixels[f] += std::int64_t{image.width()} * image.height();
        std::size_t entrant = 0;
        for (auto& [family, field] : fields_) {
          for (std::size_t i = 0; i < field.entrants().size(); ++i) {
            look(field, i, thread, image, by_file[f][entrant++]);
          }
        }
      });
    });
    Rows rows;
    std::size_t entrant = 0;
    for (const auto& [family, field] : fields_) {
      for (const Field::Entrant& who : field.entrants()) {
        Counts sum;
        std::int64_t all_images = 0, all_pixels = 0;
        for (std::size_t f = 0; f < count; ++f) {
          add(by_file[f][entrant], sum);
          all_images += images[f];
          all_pixels += pixels[f];
        }
        ++entrant;
        Row row = {
            family->name(), who.contender, static_cast<std::int64_t>(count),
            all_images,     all_pixels,    sum.says_candidates ? Cell(sum.candidates) : Cell()};
        for (const std::int64_t number : sum.by_errors) {
          row.emplace_back();
          if (sum.says_errors) row.back() = number;
        }
        row.emplace_back(sum.accepted);
        rows.push_back(std::move(row));
      }
    }
    return rows;
  }

  Rows collect(std::vector<Rows> points) const override {
    Rows sums = points.front();
    for (std::size_t p = 1; p < points.size(); ++p) {
      for (std::size_t r = 0; r < sums.size(); ++r) {
        for (std::size_t c = 2; c < sums[r].size(); ++c) {
          auto* sum = std::get_if<std::int64_t>(&sums[r][c]);
          const auto* more = std::get_if<std::int64_t>(&points[p][r][c]);
          if (sum != nullptr && more != nullptr) *sum += *more;
        }
      }
    }
    Rows rows;
    for (const Row& sum : sums) add_rows(sum, rows);
    return rows;
  }

  plot::Figure figure(const Table& table) const override {
    plot::Figure figure{.title = "Pictures without tags: quads that pass for one (paper, table I)",
                        .panels = {},
                        .columns = std::min<int>(3, static_cast<int>(fields_.size()))};
    for (const auto& [family, field] : fields_) {
      plot::Panel panel{.title = family->name(),
                        .x = {.label = "corrected bits", .categories = {}},
                        .y = {.label = "share of candidate quads", .logarithmic = true},
                        .series = {}};
      for (int errors = 0; errors <= usual_max_hamming(*family); ++errors) {
        panel.x.categories.push_back(fmt::to_string(errors));
      }
      plot::Series one{.label = "theory, one rotation", .style = 6, .spots = {}};
      plot::Series four{.label = "theory, four rotations", .style = 7, .spots = {}};
      for (const ContenderKind& kind : settings_.contenders) {
        plot::Series series{.label = kind.name, .style = kind.style, .spots = {}, .line = false};
        for (const Row& row : table.rows) {
          const std::string errors = table.word(row, "errors");
          const auto candidates = table.number(row, "candidates");
          const auto rate = table.number(row, "rate");
          if (table.word(row, "family") != family->name() ||
              table.word(row, "contender") != kind.name || errors == "all") {
            continue;
          }
          const double x = errors[0] - '0';
          if (kind.name == settings_.contenders[0].name) {
            one.spots.push_back({.x = x, .y = *table.number(row, "theory_1")});
            four.spots.push_back({.x = x, .y = *table.number(row, "theory_4")});
          }
          // None of n: at most 3 / n with 95 %.
          if (rate && candidates && *candidates > 0) {
            const bool none = *rate == 0;
            series.spots.push_back({.x = x, .y = none ? 3 / *candidates : *rate, .bound = none});
          }
        }
        if (!series.spots.empty()) panel.series.push_back(std::move(series));
      }
      panel.series.push_back(std::move(one));
      panel.series.push_back(std::move(four));
      figure.panels.push_back(std::move(panel));
    }
    return figure;
  }

  std::string summary(const Table& table) const override {
    std::vector<std::vector<std::string>> lines = {
        {"family, contender", "candidates", "false", "rate", "theory, 1 rotation", "4 rotations"}};
    for (const Row& row : table.rows) {
      if (table.word(row, "errors") != "all") continue;
      const auto candidates = table.number(row, "candidates");
      const auto rate = table.number(row, "rate");
      lines.push_back(
          {fmt::format("  {}, {}", table.word(row, "family"), table.word(row, "contender")),
           candidates ? fmt::format("{}", *candidates) : "-",
           fmt::format("{}", *table.number(row, "accepted")),
           rate ? fmt::format("{:.2g} %", 100 * *rate) : "-",
           fmt::format("{:.3g} %", 100 * *table.number(row, "theory_1")),
           fmt::format("{:.3g} %", 100 * *table.number(row, "theory_4"))});
    }
    return aligned(lines);
  }

  std::vector<std::string> conditions() const override {
    return {
        fmt::format("{} pictures without tags, each at full size and halved again and again "
                    "while its shorter side stays at 500 px{}",
                    files_.size(),
                    settings_.quick ? fmt::format(", sizes up to {} Mpx", kQuickMegapixels) : ""),
        "up to two bits corrected, as far as that is safe",
        "contenders: " + contestants(settings_)};
  }

 private:
  std::vector<std::string> chosen_files() const {
    const std::vector<std::string>& all = settings_.photographs;
    std::size_t count = settings_.quick ? std::min(kQuickFiles, all.size()) : all.size();
    if (settings_.samples > 0) count = std::min(all.size(), std::size_t(settings_.samples));
    std::vector<std::string> chosen;
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(all[i * all.size() / count]);
    return chosen;
  }

  std::size_t entrants() const {
    std::size_t count = 0;
    for (const auto& [family, field] : fields_) count += field.entrants().size();
    return count;
  }

  static void look(Field& field, std::size_t entrant, int thread, const detect::Image& image,
                   Counts& counts) {
    for (const FoundTag& tag : field.see(entrant, thread, image.view())) {
      ++counts.accepted;
      if (tag.hamming && *tag.hamming <= kMostErrors) {
        ++counts.by_errors[static_cast<std::size_t>(*tag.hamming)];
      } else {
        counts.says_errors = false;
      }
    }
    const auto candidates = field.detector(entrant, thread).candidates();
    counts.says_candidates = counts.says_candidates && candidates.has_value();
    counts.candidates += candidates.value_or(0);
  }

  static void add(const Counts& part, Counts& sum) {
    sum.candidates += part.candidates;
    sum.accepted += part.accepted;
    for (std::size_t i = 0; i < sum.by_errors.size(); ++i) sum.by_errors[i] += part.by_errors[i];
    sum.says_candidates = sum.says_candidates && part.says_candidates;
    sum.says_errors = sum.says_errors && part.says_errors;
  }

  /// A row for each number of errors, and one for all of them.
  void add_rows(const Row& sum, Rows& rows) const {
    const auto& name = std::get<std::string>(sum[0]);
    const auto at = std::find_if(fields_.begin(), fields_.end(),
                                 [&](const auto& entry) { return entry.first->name() == name; });
    const codec::Family& family = *at->first;
    const auto within = [&](int errors) {
      return errors < 0 ? 0 : codec::false_accept_rate(family.size(), family.bits(), errors);
    };
    const double megapixels = 1e-6 * static_cast<double>(std::get<std::int64_t>(sum[4]));
    const auto* candidates = std::get_if<std::int64_t>(&sum[5]);
    const int most = usual_max_hamming(family);
    for (int errors = 0; errors <= most + 1; ++errors) {
      const bool all = errors > most;
      const Cell& cell = all ? sum.back() : sum[static_cast<std::size_t>(6 + errors)];
      const auto* accepted = std::get_if<std::int64_t>(&cell);
      if (accepted == nullptr) continue;
      const double theory = all ? within(most) : within(errors) - within(errors - 1);
      const auto number = static_cast<double>(*accepted);
      rows.push_back({sum[0], sum[1], sum[2], sum[3], megapixels, sum[5],
                      all ? std::string("all") : fmt::to_string(errors), *accepted,
                      candidates != nullptr && *candidates > 0
                          ? Cell(number / static_cast<double>(*candidates))
                          : Cell(),
                      theory / 4, theory, number / megapixels});
    }
  }

  Settings settings_;
  std::vector<std::string> files_;
  std::vector<std::pair<codec::SharedFamily, Field>> fields_;
};

}  // namespace

ExperimentKind false_positives_kind() {
  return {.name = "false-positives",
          .summary = "tags seen in photographs that have none; paper, table I",
          .make = [](const Settings& settings) -> std::unique_ptr<Experiment> {
            return std::make_unique<FalsePositives>(settings);
          }};
}

}  // namespace tagmint::evaluate
