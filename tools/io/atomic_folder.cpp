#include "io/atomic_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(int error, const fs::path& path) {
  throw codec::OutputError("cannot write: " + std::generic_category().message(error), path.string(),
                           "choose another place");
}

/// "out/tags/" is the folder "out/tags".
fs::path without_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

bool write_whole(const fs::path& path, std::string_view content) {
  std::FILE* const file = std::fopen(path.c_str(), "wbx");
  if (!file) return false;
  const bool written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  const int error = errno;
  const bool closed = std::fclose(file) == 0;
  if (!written) errno = error;
  return written && closed;
}

}  // namespace

void AtomicFolder::require_possible(const fs::path& target) {
  const fs::path path = without_slash(target);
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_directory(status)) {
    throw codec::OutputError("cannot make the folder: a file has that name", path.string(),
                             "remove it or choose another name");
  }
  if (fs::is_directory(status) && !fs::is_empty(path, error)) {
    throw codec::OutputError("cannot make the folder: there is one with files in it", path.string(),
                             "remove it or choose another name");
  }
  if (!fs::is_directory(folder_of(path), error)) {
    throw codec::OutputError("cannot write: there is no folder " + folder_of(path).string(),
                             path.string(), "make it first or choose another place");
  }
  if (access(folder_of(path).c_str(), W_OK) != 0) fail(errno, path);
}

AtomicFolder::AtomicFolder(const fs::path& target) : target_(without_slash(target)) {
  require_possible(target_);
  for (int attempt = 0;; ++attempt) {
    part_ = folder_of(target_) /
            fmt::format(".{}.{}-{}.part", target_.filename().string(), ::getpid(), attempt);
    if (::mkdir(part_.c_str(), 0777) == 0) return;
    if (errno != EEXIST) fail(errno, target_);
  }
}

AtomicFolder::~AtomicFolder() {
  std::error_code ignored;
  if (!part_.empty()) fs::remove_all(part_, ignored);
}

void AtomicFolder::write(const std::string& name, std::string_view content) {
  if (!write_whole(part_ / name, content)) fail(errno, target_ / name);
}

void AtomicFolder::finish() {
  const int folder = ::open(part_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) fail(errno, target_);
  // One call for the whole file system: thousands of small files would take minutes one by one.
  const bool flushed = ::syncfs(folder) == 0;
  const int error = errno;
  ::close(folder);
  if (!flushed) fail(error, target_);
  if (::rename(part_.c_str(), target_.c_str()) != 0) fail(errno, target_);
  part_.clear();
}

}  // namespace tagmint::io
