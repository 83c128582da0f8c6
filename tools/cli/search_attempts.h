#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/process.h"
#include "tagmint/codec/search/checkpoint.h"
#include "tagmint/codec/search/lexicode.h"

namespace tagmint::cli {

/// Why and where a search ended, for a message: "after 1000 words (--limit-words)".
std::string end_text(const codec::LexicodeResult& result, const codec::LexicodeOptions& search);

/// Where a search keeps what it needs to go on later.
struct CheckpointRequest {
  std::filesystem::path file;  ///< empty = nowhere
  bool resume = false;         ///< go on from the file where there is one
};

/// A finished search.
struct Attempt {
  codec::LexicodeOptions search;
  codec::LexicodeResult result;
};

/// Runs one search, or the same one with several seeds: one after the other, with progress on
/// stderr, Ctrl-C and a checkpoint.
class SearchAttempts {
 public:
  /// Opens the checkpoint. Throws UsageError, InputError and OutputError.
  SearchAttempts(codec::LexicodeOptions search, int count, const CheckpointRequest& checkpoint,
                 const Common& common);

  /// The attempt with the most codes, the first on ties. Throws Interrupted after the checkpoint
  /// was written.
  Attempt best();

  /// To be called when the result is safe: removes a checkpoint that is not needed any more, and
  /// returns a message about one that is kept; else nothing.
  std::string put_checkpoint_away();

 private:
  using Clock = std::chrono::steady_clock;

  void open_checkpoint(const CheckpointRequest& request);
  bool time_is_up() const { return deadline_ && Clock::now() >= *deadline_; }
  std::string label(std::size_t index) const;
  Attempt run(std::size_t index, const codec::Order& order);
  void record_end(const Attempt& attempt);
  void tell(std::size_t index, const Attempt& attempt) const;

  codec::LexicodeOptions search_;
  int count_;
  const Common& common_;
  std::optional<Clock::time_point> deadline_;
  std::filesystem::path checkpoint_path_;
  std::optional<codec::Checkpoint> checkpoint_;
  codec::CheckpointContent begun_;  // what the checkpoint held
  std::string to_go_on_;  // what a later run needs to search more; empty = there is no more
  InterruptGuard guard_;
};

}  // namespace tagmint::cli
