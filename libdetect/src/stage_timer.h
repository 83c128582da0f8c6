#pragma once

#include <chrono>
#include <cstddef>

#include "tagmint/detect/detect_stats.h"

namespace tagmint::detect {

/// Adds the time until its end to one stage.
class StageTimer {
 public:
  StageTimer(DetectStats& stats, Stage stage)
      : milliseconds_(stats.stage_ms[static_cast<std::size_t>(stage)]) {}
  ~StageTimer() {
    milliseconds_ += std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& milliseconds_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace tagmint::detect
