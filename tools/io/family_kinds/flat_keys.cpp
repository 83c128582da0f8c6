#include "io/family_kinds/flat_keys.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "io/family_kinds/source_tokens.h"

namespace tagmint::io {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) + 1 - begin);
}

/// What a text between double quotes means; as written where an escape is not one of JSON's.
std::string unescaped(std::string_view written) {
  if (written.find('\\') == std::string_view::npos) return std::string(written);
  const auto json = nlohmann::json::parse(fmt::format("\"{}\"", written), nullptr, false);
  return json.is_string() ? json.get<std::string>() : std::string(written);
}

class KeyReader {
 public:
  explicit KeyReader(const FamilySource& source) : source_(source) {}

 protected:
  [[noreturn]] void fail(int line, std::string_view what) const {
    fail_in_source(what, source_, line,
                   "an OpenCV dictionary is one map of keys with numbers and quoted texts");
  }

  void add(std::string key, std::string text, int line) {
    const auto [place, is_new] =
        keys_.values.try_emplace(std::move(key), PlacedText{std::move(text), line});
    if (!is_new) {
      fail(line, fmt::format("the key '{}' comes twice, first in line {}", place->first,
                             place->second.line));
    }
  }

  void set_title(std::string_view title, int line) {
    if (!keys_.title.empty() || !keys_.values.empty()) {
      fail(line, fmt::format("a map '{}' beside other keys", title));
    }
    keys_.title = title;
  }

  const FamilySource& source_;
  FlatKeys keys_;
};

/// JSON as tokens: `{ "key" : 1, "key" : "text" }`.
class JsonKeys : KeyReader {
 public:
  explicit JsonKeys(const FamilySource& source)
      : KeyReader(source), tokens_(source_tokens(source)) {}

  FlatKeys read() {
    expect("{");
    read_members();
    expect("}");
    if (at_ < tokens_.size()) fail(line(), "something follows the last brace");
    return std::move(keys_);
  }

 private:
  int line() const { return at_ < tokens_.size() ? tokens_[at_].line : last_line(); }
  int last_line() const { return tokens_.empty() ? 1 : tokens_.back().line; }
  bool next_is(std::string_view sign) const {
    return at_ < tokens_.size() && tokens_[at_].is(sign);
  }
  void expect(std::string_view sign) {
    if (!next_is(sign)) {
      fail(line(), at_ < tokens_.size()
                       ? fmt::format("'{}' stands where '{}' is due", tokens_[at_].text, sign)
                       : fmt::format("the text ends where '{}' is due", sign));
    }
    ++at_;
  }
  const SourceToken& text(std::string_view what) {
    if (at_ == tokens_.size() || tokens_[at_].kind != SourceToken::Kind::Text) {
      fail(line(), fmt::format("{} is missing", what));
    }
    return tokens_[at_++];
  }

  void read_members() {
    if (next_is("}")) return;
    do {
      const SourceToken& key = text("a key between quotes");
      expect(":");
      if (next_is("{")) {
        set_title(key.text, key.line);
        ++at_;
        read_members();
        expect("}");
      } else {
        add(unescaped(key.text), value(), key.line);
      }
    } while (next_is(",") && ++at_);
  }

  std::string value() {
    std::string sign;
    if (next_is("-")) {
      sign = "-";
      ++at_;
    }
    if (at_ == tokens_.size() || tokens_[at_].kind == SourceToken::Kind::Sign) {
      fail(line(), "a number or a text is missing");
    }
    const SourceToken& token = tokens_[at_++];
    return token.kind == SourceToken::Kind::Text ? unescaped(token.text)
                                                 : sign + std::string(token.text);
  }

  std::vector<SourceToken> tokens_;
  std::size_t at_ = 0;
};

/// YAML line by line: `key: value`, indented or not.
class YamlKeys : KeyReader {
 public:
  using KeyReader::KeyReader;

  FlatKeys read() {
    int number = 0;
    std::string_view rest = source_.content;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      read_line(trimmed(rest.substr(0, end)), ++number);
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return std::move(keys_);
  }

 private:
  void read_line(std::string_view line, int number) {
    if (line.empty() || line[0] == '#' || line[0] == '%' || line == "---" || line == "...") return;
    const std::size_t colon = line.find(':');
    const bool spaced = colon + 1 == line.size() || line.find_first_of(" \t", colon) == colon + 1;
    if (colon == std::string_view::npos || colon == 0 || !spaced) {
      fail(number, fmt::format("'{}' is no key with a value", line.substr(0, 60)));
    }
    std::string_view key = trimmed(line.substr(0, colon));
    if (key.size() >= 2 && key.front() == '"' && key.back() == '"') {
      key = key.substr(1, key.size() - 2);
    }
    const std::string_view value = trimmed(line.substr(colon + 1));
    if (value.empty() || value[0] == '#') {
      set_title(key, number);
    } else {
      add(std::string(key), scalar(value, number), number);
    }
  }

  std::string scalar(std::string_view value, int number) const {
    const char quote = value[0];
    if (quote == '[' || quote == '{' || quote == '!') {
      fail(number, "a list or another structure as a value");
    }
    if (quote != '"' && quote != '\'') {
      return std::string(trimmed(value.substr(0, std::min(value.find(" #"), value.size()))));
    }
    std::size_t end = 1;
    while (end < value.size() && value[end] != quote) {
      end += quote == '"' && value[end] == '\\' ? 2 : 1;
    }
    if (end >= value.size()) fail(number, "a text begins here and does not end");
    const std::string_view after = trimmed(value.substr(end + 1));
    if (!after.empty() && after[0] != '#') fail(number, "something follows the quoted text");
    const std::string_view inside = value.substr(1, end - 1);
    return quote == '"' ? unescaped(inside) : std::string(inside);
  }
};

}  // namespace

FlatKeys read_flat_keys(const FamilySource& source) {
  const std::size_t first = source.content.find_first_not_of(" \t\r\n");
  const bool json = first != std::string::npos && source.content[first] == '{';
  return json ? JsonKeys(source).read() : YamlKeys(source).read();
}

}  // namespace tagmint::io
