// What a picture costs, by its size and content, decimation and threads.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "evaluate/curves.h"
#include "evaluate/experiments/kinds.h"
#include "evaluate/photographs.h"
#include "evaluate/scenes.h"
#include "evaluate/sighting.h"
#include "io/images.h"
#include "scene/random_scene.h"
#include "scene/render.h"

namespace tagmint::evaluate {
namespace {

// The paper's figures, us a pixel of photographs on a Xeon E5-2640 of 2.5 GHz.
constexpr double kPaperFull_us = 0.254;
constexpr double kPaperHalf_us = 0.072;

struct Step {
  std::string content;
  int width = 0;
  int height = 0;
  int threads = 1;
};

class Timing : public Experiment {
 public:
  explicit Timing(const Settings& settings)
      : settings_(settings), pictures_(samples_of(settings, 2, 6)) {
    contents_ = {"plain", "sparse", "clutter"};
    if (!settings.photographs.empty()) contents_.push_back("photographs");
    for (const std::string& content : contents_) {
      for (const auto& [width, height] :
           {std::pair{320, 240}, {640, 480}, {1280, 960}, {2560, 1920}}) {
        steps_.push_back({content, width, height, 1});
      }
    }
    steps_.push_back({"clutter", 2560, 1920, 2});
  }

  std::vector<Column> columns() const override {
    return {{"content",
             "plain = noise on gray; sparse = 4 tags on a gradient; clutter = shapes "
             "over one another with tags; photographs = as they are, without tags"},
            {"width_px", "of the pictures; photographs are halved to about so many pixels"},
            {"height_px", "of the pictures"},
            {"threads", "that the detector may use"},
            contender_column(),
            decimate_column(),
            {"pictures", "that were timed"},
            {"us_per_px",
             "median over pictures of the wall time for each pixel, microseconds, the "
             "fastest of the rounds"},
            {"ms", "median wall time for a picture, milliseconds"},
            {"reports", "tags reported in all of them"}};
  }

  std::vector<std::string> points() const override {
    std::vector<std::string> names;
    for (const Step& step : steps_) {
      names.push_back(fmt::format("{} {}x{}, {} thread{}", step.content, step.width, step.height,
                                  step.threads, step.threads == 1 ? "" : "s"));
    }
    return names;
  }

  Rows run(std::size_t point, const Work& work) override {
    const Step& step = steps_[point];
    const std::vector<detect::Image> pictures = draw(step, point, work);
    struct Entrant {
      std::string contender;
      double decimate;
      std::unique_ptr<Contender> detector;
      std::vector<double> us, ms;
      std::int64_t reports = 0;
    };
    std::vector<Entrant> entrants;
    for (const double decimate : {1.0, 2.0}) {
      for (const ContenderKind& kind : settings_.contenders) {
        auto detector = kind.make({.family = settings_.family,
                                   .decimate = decimate,
                                   .threads = step.threads,
                                   .max_hamming = usual_max_hamming(*settings_.family)});
        if (detector) entrants.push_back({kind.name, decimate, std::move(detector), {}, {}, 0});
      }
    }
    for (const detect::Image& picture : pictures) {
      std::vector<double> best(entrants.size(), 1e300);
      // In turns, so that what else the machine does meets all alike.
      for (int round = 0; round < kRounds; ++round) {
        for (std::size_t i = 0; i < entrants.size(); ++i) {
          work.throw_if_stopped();
          const auto start = std::chrono::steady_clock::now();
          entrants[i].detector->detect(picture.view());
          const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
          best[i] = std::min(best[i], time.count());
        }
      }
      const double pixels = static_cast<double>(picture.width()) * picture.height();
      for (std::size_t i = 0; i < entrants.size(); ++i) {
        entrants[i].us.push_back(1e6 * best[i] / pixels);
        entrants[i].ms.push_back(1e3 * best[i]);
        entrants[i].reports += static_cast<std::int64_t>(entrants[i].detector->found().size());
      }
    }
    Rows rows;
    for (const Entrant& entrant : entrants) {
      rows.push_back({step.content, std::int64_t{step.width}, std::int64_t{step.height},
                      std::int64_t{step.threads}, entrant.contender, entrant.decimate,
                      static_cast<std::int64_t>(pictures.size()), cell_of(median(entrant.us)),
                      cell_of(median(entrant.ms)), entrant.reports});
    }
    return rows;
  }

  plot::Figure figure(const Table& table) const override {
    plot::Figure figure{.title = "Time for each pixel by content and size", .panels = {}};
    for (const std::string& content : contents_) {
      for (const double decimate : {1.0, 2.0}) {
        plot::Panel panel{
            .title = fmt::format("{}, {}", content,
                                 decimate == 1 ? "full resolution" : "decimated by 2"),
            .x = {.label = "width of the picture, px", .logarithmic = true},
            .y = {.label = "time, us/px", .logarithmic = true, .low = 1e-4, .high = 0.5},
            .series = {}};
        panel.series = curves(table, settings_, "width_px", "us_per_px", [&](const Row& row) {
          return table.word(row, "content") == content &&
                 table.number(row, "decimate") == decimate && table.number(row, "threads") == 1;
        });
        panel.marks = {{.at = decimate == 1 ? kPaperFull_us : kPaperHalf_us,
                        .across = true,
                        .text = "the paper's machine, photographs"}};
        figure.panels.push_back(std::move(panel));
      }
    }
    return figure;
  }

  std::string summary(const Table& table) const override {
    std::vector<std::vector<std::string>> lines = {{"us a pixel, one thread, 1280 x 960 px"}};
    for (const std::string& content : contents_) lines[0].push_back(content);
    for (const double decimate : {1.0, 2.0}) {
      for (const ContenderKind& kind : settings_.contenders) {
        std::vector<std::string> line = {fmt::format("  {}, decimate {}", kind.name, decimate)};
        for (const Row& row : table.rows) {
          if (table.word(row, "contender") == kind.name &&
              table.number(row, "decimate") == decimate && table.number(row, "threads") == 1 &&
              table.number(row, "width_px") == 1280) {
            line.push_back(fmt::format("{:.4f}", table.number(row, "us_per_px").value_or(0)));
          }
        }
        if (line.size() > 1) lines.push_back(std::move(line));
      }
    }
    return aligned(lines);
  }

  std::vector<std::string> conditions() const override {
    return {fmt::format("{} pictures of each kind and size, each {} times in turns; the picture is "
                        "in memory; times are this machine's while it did this",
                        pictures_, kRounds),
            family_words(*settings_.family), "contenders: " + contestants(settings_)};
  }

 private:
  static constexpr int kRounds = 3;

  std::vector<detect::Image> draw(const Step& step, std::size_t point, const Work& work) const {
    std::vector<detect::Image> pictures;
    for (int i = 0; i < pictures_; ++i) {
      work.throw_if_stopped();
      if (step.content == "photographs") {
        const std::size_t count = settings_.photographs.size();
        const std::size_t file =
            static_cast<std::size_t>(i) * count / static_cast<std::size_t>(pictures_) % count;
        pictures.push_back(photograph(settings_.photographs[file], step));
      } else {
        pictures.push_back(
            scene::render(drawn(step, picture_seed(settings_.seed, point, i)), 1).image);
      }
    }
    return pictures;
  }

  /// Halved until it has about as many pixels as the step asks for.
  static detect::Image photograph(const std::string& path, const Step& step) {
    detect::Image image = io::read_gray_image(path);
    const double wanted = static_cast<double>(step.width) * step.height;
    while (static_cast<double>(image.width()) * image.height() > 2 * wanted) {
      image = halved(image);
    }
    return image;
  }

  scene::Scene drawn(const Step& step, std::uint64_t seed) const {
    // As many tags and shapes to the pixel at every size.
    const double scale = static_cast<double>(step.width) * step.height / (1280.0 * 960.0);
    scene::RandomSceneOptions options;
    options.width = step.width;
    options.height = step.height;
    options.seed = seed;
    options.effects = usual_effects();
    options.count = 0;
    options.background = scene::PlainBackground{};
    if (step.content == "sparse") {
      options.count = std::max(1, static_cast<int>(4 * scale));
      options.min_side_px = 60;
      options.max_side_px = 100;
      options.background = scene::GradientBackground{};
    } else if (step.content == "clutter") {
      options.count = std::max(2, static_cast<int>(30 * scale));
      options.min_side_px = 15;
      options.max_side_px = 80;
      options.background =
          scene::ClutterBackground{.shapes = std::max(30, static_cast<int>(500 * scale))};
    }
    const scene::TagChoice choice{settings_.family, {}};
    return scene::random_scene({&choice, 1}, options);
  }

  Settings settings_;
  int pictures_;
  std::vector<std::string> contents_;
  std::vector<Step> steps_;
};

}  // namespace

ExperimentKind timing_kind() {
  return {.name = "timing",
          .summary = "us a pixel by size, content, decimation, threads",
          .make = [](const Settings& settings) -> std::unique_ptr<Experiment> {
            return std::make_unique<Timing>(settings);
          }};
}

}  // namespace tagmint::evaluate
