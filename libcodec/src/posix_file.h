#pragma once

#include <filesystem>
#include <string_view>

namespace tagmint::codec {

/// An open file of the system that closes itself.
class Descriptor {
 public:
  /// `flags` as of open(); new files may be read and written as the umask says.
  Descriptor(const std::filesystem::path& path, int flags);
  ~Descriptor();
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool is_open() const { return fd_ >= 0; }
  int get() const { return fd_; }
  /// Closes now; false with errno when the system reports a late write error.
  bool close();

 private:
  int fd_;
};

/// All of `content`, however many bytes a single call takes; false with errno on failure.
bool write_all(int fd, std::string_view content);

/// Throws the OutputError for a file that cannot be written, with the system's reason.
///   error   an errno
[[noreturn]] void fail_to_write(int error, const std::filesystem::path& path);

}  // namespace tagmint::codec
