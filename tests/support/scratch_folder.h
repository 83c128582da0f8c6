#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tagmint::test {

/// An empty folder of its own; removed with all it holds at the end of the test.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// The full path of a file in it.
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// Writes a file in it; its full path.
  std::string write(const std::string& name, const std::string& content) const;
  /// Names of the files in it, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, const std::string& content);

}  // namespace tagmint::test
