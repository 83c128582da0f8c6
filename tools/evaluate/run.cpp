#include "evaluate/run.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "evaluate/curves.h"
#include "evaluate/points_store.h"
#include "io/atomic_files.h"
#include "plot/draw_figure.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/version.h"

namespace tagmint::evaluate {
namespace {

/// What the points of a run depend on.
nlohmann::json run_key(const ExperimentKind& kind, const Settings& settings) {
  nlohmann::json releases = nlohmann::json::array();
  for (const ContenderKind& contender : settings.contenders) {
    releases.push_back(contender.name + ": " + contender.release);
  }
  return {{"experiment", kind.name},
          {"version", codec::kVersion},
          {"seed", settings.seed},
          {"quick", settings.quick},
          {"samples", settings.samples},
          {"family", settings.family->name()},
          {"codewords", codec::family_digest(*settings.family)},
          {"contenders", releases},
          {"photographs", settings.photographs}};
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder, error)) {
    throw codec::OutputError("the folder cannot be made", folder.string(),
                             "choose another place with -o");
  }
}

std::vector<std::string> preamble(const ExperimentKind& kind, const Settings& settings,
                                  const Experiment& experiment) {
  std::vector<std::string> lines = {
      fmt::format("tagmint {} evaluate {}: {}", codec::kVersion, kind.name, kind.summary),
      fmt::format(
          "seed {}, {} settings{}", settings.seed, settings.quick ? "quick" : "full",
          settings.samples > 0 ? fmt::format(", {} samples a point", settings.samples) : "")};
  for (std::string& line : experiment.conditions()) lines.push_back(std::move(line));
  return lines;
}

std::vector<Rows> compute(Experiment& experiment, PointsStore& store, const Settings& settings,
                          const RunOptions& options) {
  const std::vector<std::string> points = experiment.points();
  const auto total = static_cast<double>(points.size());
  std::vector<Rows> all(points.size());
  std::size_t known = 0;
  for (const std::string& point : points) known += store.known().count(point);
  if (known > 0 && options.going_on) options.going_on(known, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (const auto at = store.known().find(points[i]); at != store.known().end()) {
      all[i] = at->second;
      continue;
    }
    const Work work(settings.threads, options.stop, [&](int done, int count) {
      if (!options.progress) return;
      options.progress(static_cast<double>(i) + static_cast<double>(done) / count, total,
                       points[i]);
    });
    work.throw_if_stopped();
    if (options.progress) options.progress(static_cast<double>(i), total, points[i]);
    all[i] = experiment.run(i, work);
    store.put(points[i], all[i]);
  }
  return all;
}

}  // namespace

Rows Experiment::collect(std::vector<Rows> points) const {
  Rows all;
  for (Rows& rows : points) {
    for (Row& row : rows) all.push_back(std::move(row));
  }
  return all;
}

Outcome run_experiment(const ExperimentKind& kind, const Settings& settings,
                       const RunOptions& options) {
  const std::unique_ptr<Experiment> experiment = kind.make(settings);
  make_folder(options.folder);
  const auto file = [&](const char* extension) {
    return options.folder / (std::string(kind.name) + extension);
  };
  PointsStore store(file(".points"), run_key(kind, settings), options.restart);
  Outcome outcome;
  outcome.table.columns = experiment->columns();
  outcome.table.rows = experiment->collect(compute(*experiment, store, settings, options));
  outcome.figure = experiment->figure(outcome.table);
  if (outcome.figure.note.empty()) {
    outcome.figure.note = fmt::format("{}; seed {}, {} settings", contestants(settings),
                                      settings.seed, settings.quick ? "quick" : "full");
  }
  outcome.summary = experiment->summary(outcome.table);
  outcome.conditions = experiment->conditions();
  const std::string csv = format_csv(outcome.table, preamble(kind, settings, *experiment));
  io::AtomicFiles files;
  outcome.files = {file(".csv"), file(".svg"), file(".png")};
  files.add(outcome.files[0], csv);
  files.add(outcome.files[1], plot::figure_svg(outcome.figure));
  files.add(outcome.files[2], plot::figure_png(outcome.figure));
  files.finish();
  store.remove();
  return outcome;
}

}  // namespace tagmint::evaluate
