#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "cli/process.h"
#include "cli/progress.h"
#include "cli/sheet_job.h"
#include "draw/sheet_check.h"
#include "draw/text_format.h"
#include "tagmint/codec/atomic_file.h"

namespace tagmint::cli {

/// Where `tagmint sheet` writes to: one file, one file a page ("out-{page}.svg") or one file a tag
/// ("dir/{family}-{id:05}.svg").
class SheetTarget {
 public:
  /// Throws UsageError for a format that is none, or fields that do not go together.
  ///   pattern   the value of -o; "-" is stdout
  ///   format    the name of a FileKind, or empty: the extension says it
  SheetTarget(const std::string& pattern, const std::string& format);

  const std::string& pattern() const { return pattern_; }
  /// How messages call it.
  std::string shown() const { return pattern_ == "-" ? "stdout" : pattern_; }
  draw::FileKind kind() const { return kind_; }
  bool is_file_a_tag() const;
  bool is_file_a_page() const { return name_.uses("page"); }
  /// The file of a page, counted from 0.
  std::string page_file(std::size_t page) const;
  std::string tag_file(const draw::TagGroup& group, codec::TagId id) const;

 private:
  std::string pattern_;
  draw::TextFormat name_;
  draw::FileKind kind_;
};

/// What reading back showed.
struct Verified {
  std::size_t tags = 0;
  double largest_error_mm = 0.0;
};

/// Writes the files of a job: all of them appear at the end, or none. Stops at Ctrl-C.
class SheetFiles {
 public:
  ///   verify   read every file back before it gets its name
  SheetFiles(const SheetTarget& target, const SheetJob& job, bool verify, const Common& common);

  /// Writes a plan's pages. Throws UsageError when several pages would go into a file that holds
  /// one, OutputError when a file cannot be written or does not read back as planned.
  void write_pages(const draw::SheetPlan& plan);

  /// Writes every tag on a page of its own (draw::plan_single()); returns the number of files.
  /// Throws UsageError before anything is written when two tags would get the same file name, and
  /// as write_pages().
  std::size_t write_tags();

  const Verified& verified() const { return verified_; }

 private:
  void write_file(const std::string& name, const draw::SheetPlan& plan, std::size_t first,
                  std::size_t last, const draw::FileOptions& options);
  void verify_file(const codec::AtomicFile& file, const draw::SheetPlan& plan, std::size_t first,
                   std::size_t last);
  void publish();
  void advance();

  const SheetTarget& target_;
  const SheetJob& job_;
  InterruptGuard guard_;
  Progress progress_;
  double steps_ = 0;  // done, and in all
  double all_steps_ = 0;
  std::unique_ptr<draw::SheetChecker> checker_;  // where files are verified
  std::vector<codec::AtomicFile> finished_;
  Verified verified_;
};

/// Throws UsageError where files of the target cannot be read back.
void require_verifiable(const SheetTarget& target, const SheetArguments& arguments);

/// Throws UsageError before anything is written when two tags would get the same file name; returns
/// the number of names.
std::size_t count_tag_files(const SheetTarget& target, const SheetJob& job);

/// Throws UsageError when several pages would go into a file that holds one.
void require_room_for_pages(const SheetTarget& target, std::size_t pages);

}  // namespace tagmint::cli
