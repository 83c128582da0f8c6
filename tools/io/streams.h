#pragma once

#include <string>

namespace tagmint::io {

/// All bytes of a file; "-" is the standard input. Throws codec::InputError with the system's
/// reason.
std::string read_input(const std::string& path);

/// How messages call the file: its path, "standard input" for "-".
std::string input_name(const std::string& path);

}  // namespace tagmint::io
