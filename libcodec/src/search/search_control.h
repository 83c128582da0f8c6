#pragma once

#include <chrono>
#include <optional>

#include "tagmint/codec/search/lexicode.h"

namespace tagmint::codec {

/// Watches over a running search: when the caller wants it to end, and when to report.
class SearchControl {
 public:
  /// `options` must outlive the object. The clock starts now.
  explicit SearchControl(const LexicodeOptions& options)
      : options_(options), start_(Clock::now()), next_report_(start_ + kReportEvery) {}

  std::chrono::duration<double> elapsed() const { return Clock::now() - start_; }

  /// Time left of the limit; nothing without a limit.
  std::optional<std::chrono::duration<double>> time_left() const {
    if (!options_.time_limit) return std::nullopt;
    return *options_.time_limit - elapsed();
  }

  /// Stopped or TimeLimit when the search must end now.
  std::optional<SearchEnd> must_end() const {
    if (options_.stop.stop_requested()) return SearchEnd::Stopped;
    if (options_.time_limit && elapsed() >= *options_.time_limit) return SearchEnd::TimeLimit;
    return std::nullopt;
  }

  /// Tells the caller how far the search is, a few times a second; fills in the time.
  void report(SearchProgress progress) {
    if (!options_.progress || Clock::now() < next_report_) return;
    progress.elapsed_s = elapsed().count();
    options_.progress(progress);
    next_report_ = Clock::now() + kReportEvery;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kReportEvery{200};

  const LexicodeOptions& options_;
  Clock::time_point start_;
  Clock::time_point next_report_;
};

}  // namespace tagmint::codec
