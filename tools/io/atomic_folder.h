#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tagmint::io {

/// A new folder that appears with all of its files or not at all: they are written to a folder
/// beside it, which is renamed at the end, or removed where that does not happen.
class AtomicFolder {
 public:
  /// `target` must not exist or be an empty folder. Throws codec::OutputError, as all members do,
  /// with the system's reason.
  explicit AtomicFolder(const std::filesystem::path& target);
  ~AtomicFolder();
  AtomicFolder(const AtomicFolder&) = delete;
  AtomicFolder& operator=(const AtomicFolder&) = delete;

  /// Writes a file of that name into it.
  void write(const std::string& name, std::string_view content);
  /// Flushes all files to the disk and gives the folder its name.
  void finish();

  /// Throws codec::OutputError where `target` cannot become such a folder. Creates nothing.
  static void require_possible(const std::filesystem::path& target);

 private:
  std::filesystem::path target_;
  std::filesystem::path part_;  // where the files are written; empty once renamed
};

}  // namespace tagmint::io
