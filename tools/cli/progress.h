#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "cli/command.h"

namespace tagmint::cli {

/// What a progress display says at one moment.
struct ProgressState {
  std::string task;        ///< "search"
  std::string unit;        ///< "words"
  double done = 0;         ///< in units
  double total = 0;        ///< in units; 0 = not known
  double done_before = 0;  ///< of these, done before the clock started
  double elapsed_s = 0;    ///< since the start
  std::string note;        ///< "38 codes", may be empty
};

/// One line for a terminal, at most `columns` wide:
/// "search [#####.....]  50 %  1.2M words/s  38 codes  ETA 0:42".
std::string progress_bar(const ProgressState& state, int columns);

/// One line of JSON: {"task","unit","done","total","elapsed_s","rate","eta_s","note"}; total and
/// eta_s are null where they are not known.
std::string progress_json(const ProgressState& state);

/// Shows how far a long task is, on stderr, as --progress and --quiet ask: a bar that rewrites its
/// line (Auto: only on a terminal), or a JSON line at a time, or nothing. Use from one thread.
class Progress {
 public:
  Progress(const Common& common, std::string task, std::string unit);
  /// Clears the bar.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Starts the clock for rate and time left anew, when `done` is done already.
  void restart(double done);

  /// Tells how far the task is. Shown at most ten times a second (JSON: once), so calling it often
  /// costs little.
  void update(double done, double total, std::string_view note = {});
  /// Removes the bar from the terminal, so that a message can be written; the next update() shows
  /// it again.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  enum class Style { None, Bar, Json };

  Style style_;
  ProgressState state_;
  Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> last_shown_;
  bool bar_visible_ = false;
};

}  // namespace tagmint::cli
