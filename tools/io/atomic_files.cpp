#include "io/atomic_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <string>
#include <system_error>

#include "tagmint/codec/atomic_file.h"
#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(int error, const fs::path& path) {
  throw codec::OutputError("cannot write: " + std::generic_category().message(error), path.string(),
                           "choose another place");
}

/// A name beside `target` that nothing has.
fs::path unused_name(const fs::path& target, const char* ending) {
  fs::path name;
  for (int attempt = 0;; ++attempt) {
    name = target.parent_path() /
           fmt::format(".{}.{}-{}.{}", target.filename().string(), ::getpid(), attempt, ending);
    if (::access(name.c_str(), F_OK) != 0) return name;
  }
}

/// Writes and flushes a new file; 0 or an errno.
int write_new(const fs::path& path, std::string_view content, const struct stat* older) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (fd < 0) return errno;
  int error = older && ::fchmod(fd, older->st_mode & 07777) != 0 ? errno : 0;
  while (error == 0 && !content.empty()) {
    const ssize_t count = ::write(fd, content.data(), content.size());
    if (count >= 0) {
      content.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (error == 0 && ::fsync(fd) != 0) error = errno;
  if (::close(fd) != 0 && error == 0) error = errno;
  return error;
}

}  // namespace

AtomicFiles::~AtomicFiles() {
  for (const File& file : files_) {
    if (!file.part.empty()) ::unlink(file.part.c_str());
    if (!file.backup.empty()) ::unlink(file.backup.c_str());
  }
}

void AtomicFiles::add(const fs::path& target, std::string_view content) {
  struct stat older {};
  const bool exists = ::stat(target.c_str(), &older) == 0;
  if (exists && S_ISDIR(older.st_mode)) fail(EISDIR, target);
  if (exists && !S_ISREG(older.st_mode)) {
    devices_.push_back({target, std::string(content)});
    return;
  }
  // A symbolic link stays, and the file that it leads to is replaced.
  std::error_code error;
  const fs::path resolved = fs::weakly_canonical(fs::absolute(target), error);
  if (error) fail(error.value(), target);
  const bool known = std::any_of(files_.begin(), files_.end(),
                                 [&](const File& file) { return file.target == resolved; });
  if (known) {
    throw codec::OutputError("two results would be written to one file", target.string(),
                             "give each a name of its own");
  }
  files_.push_back({resolved, unused_name(resolved, "part"), {}, exists});
  const int failed = write_new(files_.back().part, content, exists ? &older : nullptr);
  if (failed != 0) fail(failed, target);
}

void AtomicFiles::keep_older(File& file) const {
  if (!file.replaces) return;
  const fs::path backup = unused_name(file.target, "old");
  // Where the file system has no second names, the older file cannot be brought back.
  if (::link(file.target.c_str(), backup.c_str()) == 0) file.backup = backup;
}

void AtomicFiles::take_back(std::size_t named) {
  for (std::size_t i = 0; i < named; ++i) {
    File& file = files_[i];
    if (!file.backup.empty()) {
      if (::rename(file.backup.c_str(), file.target.c_str()) == 0) file.backup.clear();
    } else if (!file.replaces) {
      ::unlink(file.target.c_str());
    }
  }
}

void AtomicFiles::finish() {
  for (const Device& device : devices_) codec::write_file_atomically(device.target, device.content);
  for (std::size_t i = 0; i < files_.size(); ++i) {
    File& file = files_[i];
    if (files_.size() > 1) keep_older(file);
    if (::rename(file.part.c_str(), file.target.c_str()) != 0) {
      const int error = errno;
      take_back(i);
      fail(error, file.target);
    }
    file.part.clear();
  }
}

}  // namespace tagmint::io
