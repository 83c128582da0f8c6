#include "io/family_kinds/family_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "io/family_kinds/gzip.h"
#include "io/streams.h"
#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

/// The text as one line of reasonable length: faults may quote whatever a file holds.
std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 300;
  std::string line;
  for (const char c : text.substr(0, kLongest)) {
    const auto code = static_cast<unsigned char>(c);
    line += code < 0x20 || code >= 0x7f ? fmt::format("\\x{:02x}", code) : std::string(1, c);
  }
  if (text.size() > kLongest) line += "...";
  return line;
}

}  // namespace

FamilySource read_family_source(const std::string& path) {
  FamilySource source{.path = path, .name = input_name(path), .content = {}};
  std::error_code unknown;
  source.is_folder = path != "-" && std::filesystem::is_directory(path, unknown);
  if (source.is_folder) return source;
  source.content = read_input(path);
  if (is_gzip(source.content)) source.content = gunzip(source.content, source.name);
  return source;
}

std::string name_from_path(const FamilySource& source) {
  if (source.path == "-") return "family";
  std::filesystem::path path = source.path;
  if (!path.has_filename()) path = path.parent_path();
  std::string name = path.filename().string();
  // Every extension goes: my.yml.gz is "my".
  if (!source.is_folder) name = name.substr(0, std::max<std::size_t>(name.find('.'), 1));
  name = possible_name(name);
  return name.empty() ? "family" : name;
}

std::string possible_name(std::string_view text) {
  std::string name(text);
  for (char& c : name) {
    const bool possible = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
                          (c >= 'a' && c <= 'z') || c == '_' || c == '-' || c == '.';
    if (!possible) c = '_';
  }
  return name;
}

void fail_in_source(std::string_view what, const FamilySource& source, int line,
                    std::string_view mend) {
  throw codec::InputError(printable(what),
                          line > 0 ? fmt::format("{}:{}", source.name, line) : source.name, mend);
}

}  // namespace tagmint::io
