#include "cli/board_configs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <span>

#include "cli/command.h"
#include "tagmint/codec/suggest.h"

namespace tagmint::cli {
namespace {

using board::ConfigKind;

constexpr std::string_view kOption = "--config";

std::optional<ConfigKind> kind_of(std::string_view name) {
  const std::span<const std::string> names = board::config_kind_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<ConfigKind>(found - names.begin());
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Whether the part before a colon is meant as a kind: a word, not the beginning of a path.
bool looks_like_kind(std::string_view word) {
  return word.size() > 1 && std::all_of(word.begin(), word.end(),
                                        [](unsigned char c) { return std::isalnum(c) != 0; });
}

ConfigKind kind_of_file(const std::string& path, board::Style style) {
  const std::string name = lower(std::filesystem::path(path).filename().string());
  for (const std::string& kind : board::config_kind_names()) {
    if (name.find(kind) != std::string::npos) return *kind_of(kind);
  }
  const std::string extension = std::filesystem::path(name).extension().string();
  if (extension == ".json") return ConfigKind::Tagmint;
  if (extension == ".yaml" || extension == ".yml") {
    if (name == "tags.yaml") return ConfigKind::Ros1;
    if (style == board::Style::Kalibr) return ConfigKind::Kalibr;
  }
  throw UsageError(fmt::format("the name '{}' does not tell which kind of config is meant", path),
                   kOption,
                   fmt::format("write KIND:FILE with one of {}, like ros2:{}",
                               fmt::join(board::config_kind_names(), ", "), path));
}

}  // namespace

ConfigTarget parse_config_target(std::string_view text, board::Style style) {
  const std::size_t colon = text.find(':');
  if (colon != std::string_view::npos && looks_like_kind(text.substr(0, colon))) {
    const std::string word = lower(std::string(text.substr(0, colon)));
    const std::string path(text.substr(colon + 1));
    const auto kind = kind_of(word);
    if (!kind) {
      const std::string hint = codec::did_you_mean(word, board::config_kind_names());
      throw UsageError(fmt::format("'{}' is no kind of config", word), kOption,
                       fmt::format("{}{}it is one of {}", hint, hint.empty() ? "" : " ",
                                   fmt::join(board::config_kind_names(), ", ")));
    }
    if (path.empty()) {
      throw UsageError(fmt::format("'{}' names no file", text), kOption,
                       fmt::format("write {}:FILE", word));
    }
    return {*kind, path};
  }
  return {kind_of_file(std::string(text), style), std::string(text)};
}

}  // namespace tagmint::cli
