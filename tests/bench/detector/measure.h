#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "detector/score.h"

namespace tagmint::bench {

/// What a detection's time is: as a clock on the wall shows it, or what the processor worked for
/// this process (all its threads), which other programs disturb less.
enum class TimeKind { Wall, Processor };

struct MeasureOptions {
  int pictures = 8;     ///< of each set, as far as it has so many
  int repetitions = 5;  ///< of each detection; the median time counts
  std::uint64_t seed = 1;
  TimeKind time = TimeKind::Wall;
};

/// One contender on one set.
struct Row {
  std::string set;
  std::string contender;
  int pictures = 0;
  Score score{};
  double nanoseconds_per_pixel = 0;
  double times_as_fast = 0;  ///< as kYardstick on the same pictures; 0 where that took no part
};

/// Every contender on every picture of the set, in turns: one pass after another over pictures and
/// contenders, so that what else the machine does meets all of them alike. The first pass warms up
/// and is judged; `repetitions` passes are timed.
std::vector<Row> measure(const PictureSet& set, std::span<const ContenderKind> kinds,
                         const MeasureOptions& options);

}  // namespace tagmint::bench
