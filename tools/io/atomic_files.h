#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include "tagmint/codec/atomic_file.h"

namespace tagmint::io {

/// Files that appear together or not at all: each is written beside its target, and all get their
/// names at the end. Where one of them cannot, those before it are taken back and the older files
/// stand again. What cannot be renamed over (a device, a pipe) is written at once.
class AtomicFiles {
 public:
  AtomicFiles() = default;
  ~AtomicFiles();
  AtomicFiles(const AtomicFiles&) = delete;
  AtomicFiles& operator=(const AtomicFiles&) = delete;

  /// Writes a file. Throws codec::OutputError, as all members do, with the system's reason, also
  /// for a target that was added before.
  void add(const std::filesystem::path& target, std::string_view content);
  /// Gives all files their names.
  void finish();

 private:
  struct File {
    codec::AtomicFile content;
    std::filesystem::path target;  // links followed
    std::filesystem::path backup;  // a second name of the older file while others are renamed
    bool replaces = false;         // there was an older file
  };

  static void keep_older(File& file);
  void take_back(std::size_t named);

  std::vector<File> files_;
};

}  // namespace tagmint::io
