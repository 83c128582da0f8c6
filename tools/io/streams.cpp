#include "io/streams.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

std::string read_all(std::FILE* file, const std::string& name) {
  std::string content;
  std::array<char, 65536> block;
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file)) {
    content.append(block.data(), count);
  }
  if (std::ferror(file)) {
    throw codec::InputError(fmt::format("cannot be read: {}", std::strerror(errno)), name,
                            "check the file and its disk");
  }
  return content;
}

}  // namespace

std::string input_name(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string read_input(const std::string& path) {
  if (path == "-") return read_all(stdin, input_name(path));
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw codec::InputError("cannot be read: it is a folder", path, "give a file");
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) {
    throw codec::InputError(fmt::format("cannot be opened: {}", std::strerror(errno)), path,
                            "check the name and the permissions");
  }
  return read_all(file.get(), path);
}

}  // namespace tagmint::io
