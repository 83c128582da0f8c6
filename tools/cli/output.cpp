#include "cli/output.h"

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "tagmint/codec/atomic_file.h"

namespace tagmint::cli {
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

}  // namespace

bool is_stdout(std::string_view target) { return target.empty() || target == "-"; }

void write_output(const std::string& target, std::string_view content) {
  if (is_stdout(target)) {
    write_stdout(content);
  } else {
    codec::write_file_atomically(target, content);
  }
}

void require_writable(const std::string& target) {
  if (is_stdout(target)) return;
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path path(target);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) {
    throw codec::OutputError("cannot write a file: it is a folder", target,
                             "give the name of a file in it");
  }
  // Devices and pipes are written in place; everything else needs its folder.
  const bool in_place = fs::exists(status) && !fs::is_regular_file(status);
  if (!in_place && !fs::is_directory(folder, error)) {
    throw codec::OutputError("cannot write: there is no folder " + folder.string(), target,
                             "make it first or choose another place");
  }
  if (access((in_place ? path : folder).c_str(), W_OK) != 0) {
    throw codec::OutputError("cannot write: " + reason(errno), target,
                             "choose a place that may be written");
  }
}

}  // namespace tagmint::cli
