#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/command.h"
#include "draw/sheet_decor.h"
#include "draw/sheet_plan.h"
#include "draw/sheet_writer.h"
#include "draw/text_format.h"

namespace tagmint::cli {

/// Where `tagmint sheet` writes to: one file, one file a page ("out-{page}.svg") or one file a tag
/// ("dir/{family}-{id:05}.svg").
class SheetTarget {
 public:
  /// Throws UsageError for a format that is none, or fields that do not go together.
  ///   pattern   the value of -o; "-" is stdout
  ///   format    "pdf", "svg", "png", or empty: the extension says it
  SheetTarget(const std::string& pattern, const std::string& format);

  const std::string& pattern() const { return pattern_; }
  bool is_file_a_tag() const;

  /// Writes a plan's pages. Throws UsageError when several pages would go into one SVG or PNG,
  /// OutputError when a file cannot be written.
  void write_pages(const draw::SheetPlan& plan, const draw::SheetDecor& decor, double dpi,
                   const Common& common) const;

  /// Writes every tag on a page of its own (draw::plan_single()); returns the number of files.
  /// Throws UsageError before anything is written when two tags would get the same file name.
  std::size_t write_tags(const std::vector<draw::TagGroup>& groups,
                         const draw::SheetOptions& options, const draw::SheetDecor& decor,
                         double dpi, const Common& common) const;

 private:
  std::string tag_file(const draw::TagGroup& group, codec::TagId id) const;

  std::string pattern_;
  draw::TextFormat name_;
  draw::FileKind format_;
};

}  // namespace tagmint::cli
