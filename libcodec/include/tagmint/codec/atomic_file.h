#pragma once

#include <filesystem>
#include <string_view>

namespace tagmint::codec {

/// Writes `content` to a new file beside `path`, flushes it to the disk and renames it to `path`,
/// so that `path` never holds half a file. What cannot be renamed over (a device, a pipe) is
/// written directly. The half-written file is removed on failure. Throws OutputError with the
/// system's reason.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace tagmint::codec
