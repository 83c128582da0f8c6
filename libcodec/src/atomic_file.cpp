#include "tagmint/codec/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>

#include "posix_file.h"

namespace tagmint::codec {
namespace {

namespace fs = std::filesystem;

void write_directly(const fs::path& path, std::string_view content) {
  Descriptor file(path, O_WRONLY);
  if (!file.is_open() || !write_all(file.get(), content) || !file.close())
    fail_to_write(errno, path);
}

/// A file that is removed again unless it was renamed into place.
class TemporaryFile {
 public:
  /// Beside `target`, under a name that no other thread, process or earlier run uses.
  explicit TemporaryFile(const fs::path& target) : path_(unused_name(target)) {}
  ~TemporaryFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const fs::path& path() const { return path_; }
  bool rename_to(const fs::path& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) return false;
    path_.clear();
    return true;
  }

 private:
  static fs::path unused_name(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    fs::path name;
    do {
      name = target.parent_path() / fmt::format(".{}.{}-{}.part", target.filename().string(),
                                                ::getpid(), counter.fetch_add(1));
    } while (::access(name.c_str(), F_OK) == 0);
    return name;
  }

  fs::path path_;
};

}  // namespace

void write_file_atomically(const fs::path& path, std::string_view content) {
  struct stat existing {};
  const bool exists = ::stat(path.c_str(), &existing) == 0;
  if (exists && S_ISDIR(existing.st_mode)) fail_to_write(EISDIR, path);
  if (exists && !S_ISREG(existing.st_mode)) return write_directly(path, content);

  // A symbolic link stays, and the file that it leads to is replaced.
  std::error_code unresolved;
  const fs::path resolved = exists ? fs::canonical(path, unresolved) : path;
  const fs::path& target = unresolved ? path : resolved;

  TemporaryFile temporary(target);
  Descriptor file(temporary.path(), O_WRONLY | O_CREAT | O_EXCL);
  if (!file.is_open()) fail_to_write(errno, path);
  if (exists && ::fchmod(file.get(), existing.st_mode & 07777) != 0) fail_to_write(errno, path);
  if (!write_all(file.get(), content) || ::fsync(file.get()) != 0 || !file.close() ||
      !temporary.rename_to(target)) {
    fail_to_write(errno, path);
  }
}

}  // namespace tagmint::codec
