#include "io/atomic_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

namespace fs = std::filesystem;

/// A name beside `target` that nothing has.
fs::path unused_name(const fs::path& target) {
  for (int attempt = 0;; ++attempt) {
    const fs::path name =
        target.parent_path() /
        fmt::format(".{}.{}-{}.old", target.filename().string(), ::getpid(), attempt);
    if (::access(name.c_str(), F_OK) != 0) return name;
  }
}

}  // namespace

AtomicFiles::~AtomicFiles() {
  for (const File& file : files_) {
    if (!file.backup.empty()) ::unlink(file.backup.c_str());
  }
}

void AtomicFiles::add(const fs::path& target, std::string_view content) {
  codec::AtomicFile file(target);
  std::error_code error;
  const fs::path resolved = fs::weakly_canonical(fs::absolute(target), error);
  const bool known = std::any_of(files_.begin(), files_.end(),
                                 [&](const File& other) { return other.target == resolved; });
  if (known) {
    throw codec::OutputError("two results would be written to one file", target.string(),
                             "give each a name of its own");
  }
  file.write(content);
  file.close();
  const bool replaces = fs::is_regular_file(resolved, error);
  files_.push_back({std::move(file), resolved, {}, replaces});
}

void AtomicFiles::keep_older(File& file) {
  if (!file.replaces) return;
  const fs::path backup = unused_name(file.target);
  // Where the file system has no second names, the older file cannot be brought back.
  if (::link(file.target.c_str(), backup.c_str()) == 0) file.backup = backup;
}

void AtomicFiles::take_back(std::size_t named) {
  std::error_code ignored;
  for (std::size_t i = 0; i < named; ++i) {
    File& file = files_[i];
    if (!file.backup.empty()) {
      if (::rename(file.backup.c_str(), file.target.c_str()) == 0) file.backup.clear();
    } else if (!file.replaces && fs::is_regular_file(file.target, ignored)) {
      ::unlink(file.target.c_str());
    }
  }
}

void AtomicFiles::finish() {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (files_.size() > 1) keep_older(files_[i]);
    try {
      files_[i].content.publish();
    } catch (...) {
      take_back(i);
      throw;
    }
  }
}

}  // namespace tagmint::io
