#pragma once

#include <string>
#include <string_view>

#include "cli/standard_output.h"

namespace tagmint::cli {

/// Whether `target` means stdout: empty or "-".
bool is_stdout(std::string_view target);

/// Writes a command's result to stdout, or to the file `target`, whole or not at all. Throws
/// OutputError.
void write_output(const std::string& target, std::string_view content);

/// Throws OutputError when `target` cannot become a file, so that long work is not done in vain:
/// its folder is missing or may not be written, or it is a folder itself. Creates nothing.
void require_writable(const std::string& target);

}  // namespace tagmint::cli
