#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "tagmint/codec/export.h"

namespace tagmint::codec {

/// A file that appears whole or not at all: its content is written to a new file beside it, which
/// is renamed at the end, or removed where that does not happen. What cannot be renamed over (a
/// device, a pipe) is written directly. All members throw OutputError with the system's reason.
class TAGMINT_API AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;

  /// The name that the file will have.
  const std::filesystem::path& path() const;
  /// Where its content is until publish(): read it there after close().
  const std::filesystem::path& written_path() const;

  void write(std::string_view content);
  /// Flushes the content to the disk; nothing more can be written.
  void close();
  /// Gives the file its name; closes it first where that was not done.
  void publish();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Writes `content` to an AtomicFile and publishes it. Throws OutputError.
TAGMINT_API void write_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace tagmint::codec
