#pragma once

#include <filesystem>
#include <string>

namespace tagmint::test {

/// The source tree that the tests were built from.
std::filesystem::path source_folder();

/// The path of the built program `tagmint`; empty in a build without it.
std::string program_path();

}  // namespace tagmint::test
