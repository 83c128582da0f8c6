#include "posix_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "tagmint/codec/errors.h"

namespace tagmint::codec {
namespace {

std::string remedy(int error, const std::filesystem::path& path) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return fmt::format("make the folder {} first", path.parent_path().string());
    case ENOSPC:
    case EDQUOT:
      return "free some space on that disk";
    case EISDIR:
      return "give the name of a file, not of a folder";
    default:
      return "choose a place that can be written to";
  }
}

}  // namespace

Descriptor::Descriptor(const std::filesystem::path& path, int flags)
    : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}

Descriptor::~Descriptor() {
  if (fd_ >= 0) ::close(fd_);
}

bool Descriptor::close() {
  const int fd = fd_;
  fd_ = -1;
  return ::close(fd) == 0;
}

bool write_all(int fd, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(fd, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

void fail_to_write(int error, const std::filesystem::path& path) {
  throw OutputError(
      fmt::format("cannot write the file: {}", std::generic_category().message(error)),
      path.string(), remedy(error, path));
}

}  // namespace tagmint::codec
