#pragma once

#include <cstddef>
#include <string>

#include "cli/sheet_job.h"

namespace tagmint::cli {

/// What became of a plan, or would: the sheet in one line, then one line a group with both sizes
/// and how many fit. What a person needs to set up a detector.
///   what   the output's name
std::string sheet_report(const SheetJob& job, const draw::SheetPlan& plan, const std::string& what);

/// The same for files of one tag each.
std::string tag_files_report(const SheetJob& job, std::size_t files, const std::string& what);

/// One line a page: what stands on it.
std::string page_list(const draw::SheetPlan& plan);

}  // namespace tagmint::cli
