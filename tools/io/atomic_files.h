#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tagmint::io {

/// Files that appear together or not at all: each is written beside its target, and all get their
/// names at the end. Where one of them cannot, those before it are taken back and the older files
/// stand again.
class AtomicFiles {
 public:
  AtomicFiles() = default;
  /// Removes what was written and has no name yet.
  ~AtomicFiles();
  AtomicFiles(const AtomicFiles&) = delete;
  AtomicFiles& operator=(const AtomicFiles&) = delete;

  /// Writes a file beside `target`; a device or pipe, which nothing can be renamed to, is written
  /// in finish(). Throws codec::OutputError, as all members do, with the system's reason, also for
  /// a target that was added before.
  void add(const std::filesystem::path& target, std::string_view content);
  /// Gives all files their names.
  void finish();

 private:
  struct File {
    std::filesystem::path target;
    std::filesystem::path part;    // written, not yet named; empty once it is
    std::filesystem::path backup;  // a second name of the older file while others are renamed
    bool replaces = false;         // there was an older file
  };
  struct Device {
    std::filesystem::path target;
    std::string content;
  };

  void keep_older(File& file) const;
  void take_back(std::size_t named);

  std::vector<File> files_;
  std::vector<Device> devices_;
};

}  // namespace tagmint::io
