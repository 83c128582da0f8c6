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

/// A name beside `target` that no other thread, process or earlier run uses.
fs::path unused_name(const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  fs::path name;
  do {
    name = target.parent_path() / fmt::format(".{}.{}-{}.part", target.filename().string(),
                                              ::getpid(), counter.fetch_add(1));
  } while (::access(name.c_str(), F_OK) == 0);
  return name;
}

/// Where to put a file called `path`, and how what is there now may be used.
struct Place {
  bool is_new = true;
  bool in_place = false;  // a device or a pipe
  mode_t mode = 0;        // of the file that is there
  fs::path target;        // the path, or what its symbolic link leads to
};

Place place_of(const fs::path& path) {
  struct stat existing {};
  if (::stat(path.c_str(), &existing) != 0) return {.target = path};
  if (S_ISDIR(existing.st_mode)) fail_to_write(EISDIR, path);
  if (!S_ISREG(existing.st_mode)) return {.is_new = false, .in_place = true, .target = path};
  // A symbolic link stays, and the file that it leads to is replaced.
  std::error_code unresolved;
  const fs::path resolved = fs::canonical(path, unresolved);
  return {.is_new = false,
          .mode = static_cast<mode_t>(existing.st_mode & 07777),
          .target = unresolved ? path : resolved};
}

}  // namespace

struct AtomicFile::Parts {
  explicit Parts(const fs::path& path)
      : path_(path),
        place_(place_of(path)),
        written_path_(place_.in_place ? path : unused_name(place_.target)),
        file_(written_path_, place_.in_place ? O_WRONLY : O_WRONLY | O_CREAT | O_EXCL) {
    if (!file_.is_open()) fail_to_write(errno, path);
    if (place_.is_new || place_.in_place) return;
    if (::fchmod(file_.get(), place_.mode) != 0) {
      const int error = errno;
      ::unlink(written_path_.c_str());  // the destructor does not run
      fail_to_write(error, path);
    }
  }
  ~Parts() {
    if (!place_.in_place && !published_) ::unlink(written_path_.c_str());
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void close() {
    if (!file_.is_open()) return;
    const bool flushed = place_.in_place || ::fsync(file_.get()) == 0;
    if (!flushed || !file_.close()) fail_to_write(errno, path_);
  }

  fs::path path_;
  Place place_;
  fs::path written_path_;
  Descriptor file_;
  bool published_ = false;
};

AtomicFile::AtomicFile(const fs::path& path) : parts_(std::make_unique<Parts>(path)) {}
AtomicFile::~AtomicFile() = default;
AtomicFile::AtomicFile(AtomicFile&& other) noexcept = default;
AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept = default;

const fs::path& AtomicFile::path() const { return parts_->path_; }

const fs::path& AtomicFile::written_path() const { return parts_->written_path_; }

void AtomicFile::write(std::string_view content) {
  if (!write_all(parts_->file_.get(), content)) fail_to_write(errno, parts_->path_);
}

void AtomicFile::close() { parts_->close(); }

void AtomicFile::publish() {
  parts_->close();
  if (parts_->place_.in_place || parts_->published_) return;
  if (::rename(parts_->written_path_.c_str(), parts_->place_.target.c_str()) != 0) {
    fail_to_write(errno, parts_->path_);
  }
  parts_->published_ = true;
}

void write_file_atomically(const fs::path& path, std::string_view content) {
  AtomicFile file(path);
  file.write(content);
  file.publish();
}

}  // namespace tagmint::codec
