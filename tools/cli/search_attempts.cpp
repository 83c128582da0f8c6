#include "cli/search_attempts.h"

#include <fmt/format.h>

#include <utility>

#include "cli/generate_plan.h"
#include "cli/progress.h"
#include "cli/terminal.h"

namespace tagmint::cli {
namespace {

using codec::LexicodeOptions;
using codec::LexicodeResult;
using codec::SearchEnd;
using codec::SearchProgress;

/// Shows a search's progress, phase by phase: rate and time left are those of the phase.
class SearchDisplay {
 public:
  SearchDisplay(const Common& common, std::string label)
      : progress_(common, "search", "words"), label_(std::move(label)) {}

  void update(const SearchProgress& state) {
    if (phase_ != state.phase) {
      phase_ = state.phase;
      progress_.restart(state.phase_done);
    }
    const std::string phase =
        state.phases > 1
            ? fmt::format("phase {} of {}, ", static_cast<int>(state.phase), state.phases)
            : std::string();
    progress_.update(state.phase_done, state.phase_total,
                     fmt::format("{}{}{} codes", label_, phase, state.codes));
  }

  void clear() { progress_.clear(); }

 private:
  Progress progress_;
  std::string label_;
  std::optional<codec::SearchPhase> phase_;
};

}  // namespace

std::string end_text(const LexicodeResult& result, const LexicodeOptions& search) {
  const std::string words = fmt::format("after {} words", result.words_searched);
  switch (result.end) {
    case SearchEnd::Complete:
      return fmt::format("all 2^{} words searched", search.layout.bits());
    case SearchEnd::LimitWords:
      return words + " (--limit-words)";
    case SearchEnd::LimitCodes:
      return words + " (--limit-codes)";
    case SearchEnd::TimeLimit:
      return words + " (--time-limit)";
    case SearchEnd::Stopped:
      break;
  }
  return words;
}

SearchAttempts::SearchAttempts(LexicodeOptions search, int count,
                               const CheckpointRequest& checkpoint, const Common& common)
    : search_(std::move(search)),
      count_(count),
      common_(common),
      checkpoint_path_(checkpoint.file) {
  if (search_.time_limit) {
    deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(*search_.time_limit);
  }
  if (!checkpoint.file.empty()) open_checkpoint(checkpoint);
}

void SearchAttempts::open_checkpoint(const CheckpointRequest& request) {
  const codec::CheckpointParameters parameters{rules_of(search_), count_, search_.limit_words,
                                               search_.limit_codes};
  if (!request.resume || !std::filesystem::exists(request.file)) {
    checkpoint_ = codec::Checkpoint::begin(request.file, parameters);
    if (request.resume) {
      say(common_, fmt::format("no checkpoint yet: searching from the beginning ({})",
                               request.file.string()));
    }
    return;
  }
  checkpoint_ = codec::Checkpoint::resume(request.file, parameters);
  begun_ = checkpoint_->take_content();
  const codec::SearchState& state = begun_.state;
  const std::string where = static_cast<int>(begun_.finished.size()) < count_
                                ? fmt::format("{}phase {}, {} codes", label(begun_.finished.size()),
                                              static_cast<int>(state.phase), state.codewords.size())
                                : "all attempts are done";
  say(common_, fmt::format("going on from {}: {}", request.file.string(), where));
}

std::string SearchAttempts::label(std::size_t index) const {
  return count_ > 1 ? fmt::format("attempt {} of {}, ", index + 1, count_) : std::string();
}

Attempt SearchAttempts::best() {
  const std::vector<codec::Order> orders = attempt_orders(
      search_.order, search_.layout, search_.min_hamming, search_.complexity, count_);
  std::optional<Attempt> best;
  const auto keep_better = [&](Attempt attempt) {
    if (!best || attempt.result.codewords.size() > best->result.codewords.size()) {
      best = std::move(attempt);
    }
  };
  std::size_t next = 0;
  for (LexicodeResult& result : begun_.finished) {
    Attempt attempt{search_, std::move(result)};
    attempt.search.order = orders[next++];
    keep_better(std::move(attempt));
  }
  for (; next < orders.size(); ++next) {
    if (best && time_is_up()) {
      say(common_, fmt::format("{} of {} attempts made (--time-limit)", next, count_));
      to_go_on_ = "more time";
      break;
    }
    Attempt attempt = run(next, orders[next]);
    record_end(attempt);
    tell(next, attempt);
    keep_better(std::move(attempt));
  }
  return std::move(*best);
}

Attempt SearchAttempts::run(std::size_t index, const codec::Order& order) {
  Attempt attempt{search_, {}};
  LexicodeOptions& search = attempt.search;
  search.order = order;
  LexicodeOptions running = search;
  running.stop = guard_.token();
  if (deadline_) running.time_limit = std::chrono::duration<double>(*deadline_ - Clock::now());
  if (checkpoint_) {
    running.step = [this](const codec::SearchStep& step) { checkpoint_->add(step); };
  }
  SearchDisplay display(common_, label(index));
  running.progress = [&](const SearchProgress& state) { display.update(state); };
  attempt.result = codec::search_lexicode(running, std::exchange(begun_.state, {}));
  display.clear();
  if (checkpoint_) checkpoint_->flush();
  guard_.throw_if_interrupted(
      checkpoint_ ? fmt::format("what was searched is in {}; go on with --resume",
                                checkpoint_path_.string())
                  : "nothing was written; give --checkpoint to be able to go on, or --time-limit "
                    "to keep what is found");
  return attempt;
}

void SearchAttempts::record_end(const Attempt& attempt) {
  const bool ended_by_time = attempt.result.end == SearchEnd::TimeLimit;
  if (attempt.result.end != SearchEnd::Complete && (count_ == 1 || ended_by_time)) {
    to_go_on_ = ended_by_time ? "more time" : "a larger limit";
  } else if (checkpoint_) {
    checkpoint_->end_attempt(attempt.result);
  }
}

void SearchAttempts::tell(std::size_t index, const Attempt& attempt) const {
  if (count_ == 1) return;
  say(common_,
      fmt::format("{}{}: {} codes, {}", label(index), codec::to_string(attempt.search.order),
                  attempt.result.codewords.size(), end_text(attempt.result, attempt.search)));
}

std::string SearchAttempts::put_checkpoint_away() {
  if (!checkpoint_) return {};
  if (!to_go_on_.empty()) {
    return fmt::format("{} is kept: --resume with {} goes on", checkpoint_path_.string(),
                       to_go_on_);
  }
  checkpoint_.reset();
  std::error_code ignored;  // a file that stays does no harm
  std::filesystem::remove(checkpoint_path_, ignored);
  return {};
}

}  // namespace tagmint::cli
