#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "evaluate/experiment.h"

namespace tagmint::evaluate {

/// Where a run writes and whom it tells.
struct RunOptions {
  std::filesystem::path folder = ".";  ///< made where it is missing
  bool restart = false;                ///< points of an earlier run are not used
  std::stop_token stop = {};
  /// Points done (with parts of them), of all, and those done by an earlier run.
  std::function<void(double done, double total, const std::string& point)> progress = {};
  /// Told once, before the first point, when an earlier run is gone on with.
  std::function<void(std::size_t known, std::size_t total)> going_on = {};
};

/// What a run came to.
struct Outcome {
  Table table;
  plot::Figure figure;
  std::string summary;
  std::vector<std::string> conditions;       ///< Experiment::conditions()
  std::vector<std::filesystem::path> files;  ///< written
};

/// Runs an experiment: DIR/NAME.csv, NAME.svg and NAME.png, all or none of them. Points are kept in
/// DIR/NAME.points while it runs; a run that was ended goes on from there, and its files are those
/// of a run that was not (times and memory that are measured excepted).
///   errors   Stopped when the stop token asked for it; codec::InputError and codec::OutputError
Outcome run_experiment(const ExperimentKind& kind, const Settings& settings,
                       const RunOptions& options);

}  // namespace tagmint::evaluate
