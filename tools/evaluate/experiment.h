#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evaluate/contender.h"
#include "evaluate/table.h"
#include "evaluate/work.h"
#include "plot/figure.h"
#include "tagmint/codec/family.h"

namespace tagmint::evaluate {

/// What an experiment is run with.
struct Settings {
  std::uint64_t seed = 1;
  bool quick = false;          ///< about a minute instead of full statistics
  int samples = 0;             ///< pictures (repetitions) a point; 0 = the experiment's own number
  codec::SharedFamily family;  ///< the tags that are shown and looked for
  bool own_family = false;     ///< `family` was asked for, not taken as the usual one
  std::vector<ContenderKind> contenders;  ///< who takes part, at least one
  std::vector<std::string> photographs;   ///< image files without tags, sorted
  int threads = 1;                        ///< that pictures are shared by
};

/// An experiment with its settings. Its table is made of *points*: parts that are computed one
/// after another and kept on disk. A point depends on the settings alone (times and memory
/// excepted), never on threads or on other points.
class Experiment {
 public:
  virtual ~Experiment() = default;
  virtual std::vector<Column> columns() const = 0;
  /// Names of the points, all different.
  virtual std::vector<std::string> points() const = 0;
  /// Computes a point; throws Stopped when the work is to end.
  virtual Rows run(std::size_t point, const Work& work) = 0;
  /// Of the rows of all points, the rows of the table: usually just those.
  virtual Rows collect(std::vector<Rows> points) const;
  virtual plot::Figure figure(const Table& table) const = 0;
  /// Some lines for stdout that say what came out.
  virtual std::string summary(const Table& table) const = 0;
  /// Lines of the CSV's head: the scene, the camera, who takes part.
  virtual std::vector<std::string> conditions() const = 0;
};

/// How to make an experiment.
struct ExperimentKind {
  std::string_view name;     ///< as it is called on the command line, and the name of its files
  std::string_view summary;  ///< one line
  /// Throws codec::InputError where the settings lack something (photographs).
  std::unique_ptr<Experiment> (*make)(const Settings& settings);
};

/// All experiments, in the order of the paper.
std::span<const ExperimentKind> experiment_kinds();

}  // namespace tagmint::evaluate
