#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/terminal.h"

namespace tagmint::cli {
namespace {

constexpr int kBarCells = 20;

double rate_of(const ProgressState& state) {
  return state.elapsed_s > 0 ? (state.done - state.done_before) / state.elapsed_s : 0.0;
}

/// Seconds left at the average rate so far; nothing while that is not known.
std::optional<double> time_left_s(const ProgressState& state) {
  const double rate = rate_of(state);
  if (state.total <= 0 || rate <= 0) return std::nullopt;
  return std::max(0.0, state.total - state.done) / rate;
}

/// Three significant digits and k, M, G, T: "1.23M".
std::string short_number(double value) {
  constexpr std::array<std::string_view, 5> kSuffixes = {"", "k", "M", "G", "T"};
  std::size_t power = 0;
  while (value >= 999.5 && power + 1 < kSuffixes.size()) {
    value /= 1000;
    ++power;
  }
  return fmt::format("{:.3g}{}", value, kSuffixes[power]);
}

std::string clock_time(double seconds) {
  constexpr double kLongest = 1e9;  // thirty years: as good as for ever
  if (seconds > kLongest) return "years";
  const long long whole = std::llround(seconds);
  const long long hours = whole / 3600;
  if (hours >= 48) return fmt::format("{} days", hours / 24);
  if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

void write_stderr(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

std::string progress_bar(const ProgressState& state, int columns) {
  std::string line = state.task;
  if (state.total > 0) {
    const double share = std::clamp(state.done / state.total, 0.0, 1.0);
    const int full = static_cast<int>(share * kBarCells);
    line += fmt::format(" [{:#<{}}{:.<{}}] {:3.0f} %", "", full, "", kBarCells - full,
                        std::floor(share * 100));
  }
  if (const double rate = rate_of(state); rate > 0) {
    line += fmt::format("  {} {}/s", short_number(rate), state.unit);
  }
  if (!state.note.empty()) line += "  " + state.note;
  if (const auto left = time_left_s(state)) line += "  ETA " + clock_time(*left);
  if (static_cast<int>(line.size()) > columns) line.resize(std::max(columns, 0));
  return line;
}

std::string progress_json(const ProgressState& state) {
  nlohmann::ordered_json line;
  line["task"] = state.task;
  line["unit"] = state.unit;
  line["done"] = state.done;
  line["total"] = state.total > 0 ? nlohmann::ordered_json(state.total) : nullptr;
  line["elapsed_s"] = state.elapsed_s;
  line["rate"] = rate_of(state);
  const auto left = time_left_s(state);
  line["eta_s"] = left ? nlohmann::ordered_json(*left) : nullptr;
  line["note"] = state.note;
  return line.dump();
}

Progress::Progress(const Common& common, std::string task, std::string unit) {
  const bool bar = common.progress == ProgressMode::Always ||
                   (common.progress == ProgressMode::Auto && is_terminal(STDERR_FILENO));
  const bool json = common.progress == ProgressMode::Json;
  style_ = common.quiet ? Style::None : json ? Style::Json : bar ? Style::Bar : Style::None;
  state_.task = std::move(task);
  state_.unit = std::move(unit);
}

Progress::~Progress() { clear(); }

void Progress::restart(double done) {
  start_ = Clock::now();
  state_.done_before = done;
}

void Progress::update(double done, double total, std::string_view note) {
  if (style_ == Style::None) return;
  const Clock::time_point now = Clock::now();
  const auto interval = std::chrono::milliseconds(style_ == Style::Json ? 1000 : 100);
  if (last_shown_ && now - *last_shown_ < interval) return;
  last_shown_ = now;
  state_.done = done;
  state_.total = total;
  state_.elapsed_s = std::chrono::duration<double>(now - start_).count();
  state_.note = note;
  if (style_ == Style::Json) {
    write_stderr(progress_json(state_) + "\n");
  } else {
    write_stderr("\r\033[K" + progress_bar(state_, terminal_columns(STDERR_FILENO) - 1));
    bar_visible_ = true;
  }
}

void Progress::clear() {
  if (!bar_visible_) return;
  write_stderr("\r\033[K");
  bar_visible_ = false;
  last_shown_.reset();
}

}  // namespace tagmint::cli
