#pragma once

#include <span>
#include <string>

#include "cli/command.h"
#include "cli/output.h"
#include "draw/file_canvas.h"

namespace tagmint::cli {

/// The smallest edge that is printed: below, the cells come near the steps in which a PDF is drawn.
inline constexpr double kLeastEdgeMm = 0.1;

/// Adds --dpi and --format for a drawing of one page.
void add_drawing_options(CLI::App& app, double& dpi, std::string& format);

/// The kind of file of a drawing: by the option, else by the output's extension. Throws UsageError.
draw::FileKind drawing_kind(const std::string& format, const std::string& output);

/// A result that goes to a file, or to stdout for "-".
struct Result {
  std::string target;
  std::string content;
};

/// Throws OutputError where a target cannot become a file, UsageError where two results go to
/// stdout. Creates nothing.
void require_writable(std::span<const Result> results);

/// Writes all results, or none where one fails. Throws OutputError.
void write_results(std::span<const Result> results);

}  // namespace tagmint::cli
