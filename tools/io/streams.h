#pragma once

#include <string>
#include <string_view>

namespace tagmint::io {

/// All bytes of a file; "-" is the standard input. Throws codec::InputError with the system's
/// reason.
std::string read_input(const std::string& path);

/// Writes a whole file, or nothing of it (codec::write_file_atomically); "-" is the standard
/// output. Throws codec::OutputError with the system's reason.
void write_output(const std::string& path, std::string_view content);

/// How messages call the file: its path, "standard input" for "-".
std::string input_name(const std::string& path);

}  // namespace tagmint::io
