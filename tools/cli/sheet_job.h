#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/sheet_options.h"
#include "draw/file_canvas.h"
#include "draw/sheet_decor.h"
#include "draw/sheet_plan.h"

namespace tagmint::cli {

/// Tags whose size was rounded, so that each cell is a whole number of a picture's dots.
struct RoundedSize {
  std::string family;
  double asked_mm = 0.0;  ///< edge
  double drawn_mm = 0.0;
  int dots_a_cell = 0;
  double error() const { return drawn_mm / asked_mm - 1; }
};

/// What `tagmint sheet` is to do.
struct SheetJob {
  std::vector<draw::TagGroup> groups;
  draw::SheetOptions page;
  draw::SheetDecor decor;
  draw::FileOptions file;
  std::vector<RoundedSize> rounded;   ///< of pictures only
  std::vector<std::string> warnings;  ///< a line each
};

/// Reads the options for a kind of file. Throws UsageError for options that do not go together or
/// have no meaning there, InputError for a family that cannot be read, std::invalid_argument and
/// draw::DoesNotFit with what is wrong.
///   file_a_tag   each tag is a page of its own, without paper, notes and ruler
SheetJob sheet_job(const SheetArguments& arguments, draw::FileKind kind, bool file_a_tag);

/// The plan of a job that puts many tags on a page. A ruler that was not asked for is left out of
/// `job.decor` where the tags only fit without.
draw::SheetPlan plan_job(SheetJob& job, const SheetArguments& arguments);

}  // namespace tagmint::cli
