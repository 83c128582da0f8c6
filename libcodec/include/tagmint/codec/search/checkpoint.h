#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "tagmint/codec/export.h"
#include "tagmint/codec/search/crew.h"
#include "tagmint/codec/search/lexicode.h"
#include "tagmint/codec/search/search_state.h"

namespace tagmint::codec {

/// The searches that a checkpoint belongs to: `attempts` of them by the same rules, the first in
/// the order that the rules give.
struct TAGMINT_API CheckpointParameters {
  SearchRules rules;
  int attempts = 1;
  /// Of each attempt, where there are several: attempts that went differently far cannot be
  /// compared. The limits of a single one may change from run to run.
  std::optional<std::uint64_t> limit_words = std::nullopt;
  std::optional<std::size_t> limit_codes = std::nullopt;
};

/// How far these searches are.
struct TAGMINT_API CheckpointContent {
  std::vector<LexicodeResult> finished;  ///< the attempts that are done, in order
  SearchState state;                     ///< of the one that is not
};

/// A file from which a search can go on after whatever ended it. Steps are added at its end as they
/// come, so that nothing that was written is ever written again:
///
///     tagmint checkpoint 1
///     {"layout": ..., "min_hamming": ..., "order": ..., "complexity": ..., "attempts": ...}
///     record, record, ...      each with a digest of itself and all before it
///
/// Steps are in the file a fifth of a second after they were made, and flushed to the disk every
/// ten seconds: a killed program loses the former, a machine without power the latter. A record
/// that was cut off is left out when the file is read; a changed one is refused. One search at a
/// time may use a file.
class TAGMINT_API Checkpoint {
 public:
  /// Begins a new file. Throws OutputError when it cannot be written or exists already.
  static Checkpoint begin(const std::filesystem::path& path,
                          const CheckpointParameters& parameters);

  /// Opens the file of an earlier search, to go on from `content()`. Throws InputError when it
  /// cannot be read, is damaged, of another version, or belongs to a search with other parameters,
  /// and OutputError when it cannot be written or is in use.
  static Checkpoint resume(const std::filesystem::path& path,
                           const CheckpointParameters& parameters);

  /// Writes what is not written yet; failures are lost, so call flush() first.
  ~Checkpoint();
  Checkpoint(Checkpoint&&) noexcept;
  Checkpoint& operator=(Checkpoint&&) noexcept;

  /// What the file held when it was opened.
  const CheckpointContent& content() const;
  CheckpointContent take_content();

  /// Adds one step of the attempt that is running. Throws OutputError.
  void add(const SearchStep& step);
  /// The attempt that is running has ended; the next step is one of the next.
  void end_attempt(const LexicodeResult& result);
  /// Writes all steps to the disk. Throws OutputError.
  void flush();

 private:
  class File;
  explicit Checkpoint(std::unique_ptr<File> file);
  std::unique_ptr<File> file_;
};

}  // namespace tagmint::codec
