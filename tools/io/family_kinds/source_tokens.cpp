#include "io/family_kinds/source_tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>

namespace tagmint::io {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Walks through a text and counts its lines.
class Lexer {
 public:
  explicit Lexer(const FamilySource& source) : source_(source), rest_(source.content) {}

  std::vector<SourceToken> tokens() {
    std::vector<SourceToken> tokens;
    while (!rest_.empty()) {
      if (!skip_blank()) tokens.push_back(next());
    }
    return tokens;
  }

 private:
  /// Passes over one blank, comment or preprocessor line; false when a token stands here.
  bool skip_blank() {
    if (rest_.starts_with("//")) {
      take(std::min(rest_.find('\n'), rest_.size()));
    } else if (rest_.starts_with("/*")) {
      const std::size_t end = rest_.find("*/", 2);
      if (end == std::string_view::npos) fail("a comment begins here and does not end");
      take(end + 2);
    } else if (rest_[0] == '#' && at_line_start_) {
      skip_directive();
    } else if (std::string_view(" \t\r\n\f\v").find(rest_[0]) != std::string_view::npos) {
      take(1);
    } else {
      return false;
    }
    return true;
  }

  /// A line of the preprocessor goes on after a backslash.
  void skip_directive() {
    std::size_t end = rest_.find('\n');
    while (end != std::string_view::npos &&
           rest_.substr(0, end).find_last_not_of("\r") != std::string_view::npos &&
           rest_[rest_.substr(0, end).find_last_not_of("\r")] == '\\') {
      end = rest_.find('\n', end + 1);
    }
    take(std::min(end, rest_.size()));
  }

  SourceToken next() {
    const char first = rest_[0];
    if (first == '"' || first == '\'') return quoted(first);
    std::size_t length = 1;
    const bool word = is_letter(first);
    const bool number = is_digit(first);
    const auto belongs = [&](char c) {
      return is_letter(c) || is_digit(c) || (number && (c == '.' || c == '\''));
    };
    if (word || number) {
      while (length < rest_.size() && belongs(rest_[length])) ++length;
    }
    const auto kind = word     ? SourceToken::Kind::Word
                      : number ? SourceToken::Kind::Number
                               : SourceToken::Kind::Sign;
    const SourceToken token{kind, rest_.substr(0, length), line_};
    take(length);
    return token;
  }

  SourceToken quoted(char quote) {
    std::size_t end = 1;
    while (end < rest_.size() && rest_[end] != quote && rest_[end] != '\n') {
      end += rest_[end] == '\\' ? 2 : 1;
    }
    if (end >= rest_.size() || rest_[end] != quote) fail("a text begins here and does not end");
    const SourceToken token{SourceToken::Kind::Text, rest_.substr(1, end - 1), line_};
    take(end + 1);
    return token;
  }

  void take(std::size_t count) {
    for (const char c : rest_.substr(0, count)) {
      line_ += c == '\n';
      at_line_start_ = c == '\n' || (at_line_start_ && (c == ' ' || c == '\t' || c == '\r'));
    }
    rest_.remove_prefix(count);
  }

  [[noreturn]] void fail(std::string_view what) const {
    fail_in_source(what, source_, line_, "complete it");
  }

  const FamilySource& source_;
  std::string_view rest_;
  int line_ = 1;
  bool at_line_start_ = true;
};

}  // namespace

std::vector<SourceToken> source_tokens(const FamilySource& source) {
  return Lexer(source).tokens();
}

std::uint64_t token_number(const SourceToken& token, const FamilySource& source) {
  std::string digits(token.text);
  std::erase(digits, '\'');
  int base = 10;
  std::size_t prefix = 2;
  if (digits.starts_with("0x") || digits.starts_with("0X")) {
    base = 16;
  } else if (digits.starts_with("0b") || digits.starts_with("0B")) {
    base = 2;
  } else if (digits.size() > 1 && digits[0] == '0' && is_digit(digits[1])) {
    base = 8;
    prefix = 1;
  } else {
    prefix = 0;
  }
  digits.erase(digits.find_last_not_of("uUlL") + 1);
  std::uint64_t number = 0;
  const char* const begin = digits.data() + std::min(prefix, digits.size());
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(begin, end, number, base);
  if (error == std::errc::result_out_of_range) {
    fail_in_source(fmt::format("{} has more than 64 bits", token.text), source, token.line,
                   "correct it");
  }
  if (error != std::errc() || stop != end) {
    fail_in_source(fmt::format("'{}' is not a whole number", token.text), source, token.line,
                   "write it like 0x1d5c6");
  }
  return number;
}

}  // namespace tagmint::io
