#include "io/family_kinds/source_facts.h"

#include <fmt/format.h>

#include "io/family_kinds/source_tokens.h"

namespace tagmint::io {
namespace {

using Kind = SourceToken::Kind;

/// Reads patterns of tokens; what fits none is passed over.
class Collector {
 public:
  explicit Collector(const FamilySource& source)
      : source_(source), tokens_(source_tokens(source)) {}

  SourceFacts collect() {
    while (at_ < tokens_.size()) {
      if (!read_list() && !read_item() && !read_field() && !read_table_head() && !read_name())
        ++at_;
    }
    if (facts_.name.empty()) facts_.name = created_name_;
    return std::move(facts_);
  }

 private:
  /// The token `ahead` places from here; an empty sign behind the end.
  const SourceToken& peek(std::size_t ahead) const {
    static const SourceToken nothing;
    return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead] : nothing;
  }
  bool is_kind(std::size_t ahead, Kind kind) const {
    return at_ + ahead < tokens_.size() && tokens_[at_ + ahead].kind == kind;
  }

  /// A number `ahead` places from here, as "7", "-7", "(7)" or "UINT64_C(7)"; moves `ahead` behind
  /// it.
  std::optional<std::uint64_t> number(std::size_t& ahead) const {
    std::size_t i = ahead;
    const bool macro = is_kind(i, Kind::Word) && peek(i + 1).is("(");
    const bool bracket = macro || peek(i).is("(");
    if (bracket) i += macro ? 2 : 1;
    const bool negative = peek(i).is("-");
    if (negative) ++i;
    if (!is_kind(i, Kind::Number) || (bracket && !peek(i + 1).is(")"))) return std::nullopt;
    const std::uint64_t value = token_number(peek(i), source_);
    ahead = i + (bracket ? 2 : 1);
    return negative ? 0 - value : value;
  }

  /// `name[N] = {`, `name[] {`: the name before the brace at `at_`, and N.
  std::pair<std::string, std::optional<PlacedNumber>> list_head() const {
    std::size_t i = at_;
    const auto before = [&](std::string_view sign) {
      if (i == 0 || !tokens_[i - 1].is(sign)) return false;
      --i;
      return true;
    };
    before("=");
    if (!before("]")) return {};
    std::optional<PlacedNumber> size;
    if (i > 0 && tokens_[i - 1].kind == Kind::Number) {
      --i;
      size = {static_cast<std::int64_t>(token_number(tokens_[i], source_)), tokens_[i].line};
    } else if (i > 0 && tokens_[i - 1].kind == Kind::Word) {
      --i;  // a constant
    }
    if (!before("[") || i == 0 || tokens_[i - 1].kind != Kind::Word) return {};
    return {std::string(tokens_[i - 1].text), size};
  }

  /// `{ 1, 2, 3 }` behind a name, or a longer one without.
  bool read_list() {
    if (!peek(0).is("{")) return false;
    NumberList list;
    std::size_t ahead = 1;
    while (true) {
      const int line = peek(ahead).line;
      const std::optional<std::uint64_t> value = number(ahead);
      if (!value) break;
      list.values.push_back(*value);
      list.lines.push_back(line);
      if (!peek(ahead).is(",")) break;
      ++ahead;
    }
    if (list.values.empty()) return false;
    const auto [name, size] = list_head();
    if (!peek(ahead).is("}")) {
      if (name.empty()) return false;
      const bool ended = at_ + ahead >= tokens_.size();
      const int line = ended ? tokens_.back().line : peek(ahead).line;
      fail_in_source(ended ? fmt::format("the list '{}' has no end", name)
                           : fmt::format("'{}' stands in the list '{}'", peek(ahead).text, name),
                     source_, line, "a list holds whole numbers with commas between them");
    }
    list.size = size;
    list.line = tokens_[at_].line;
    add_list(name, std::move(list));
    at_ += ahead + 1;
    return true;
  }

  void add_list(const std::string& name, NumberList list) {
    const auto [place, is_new] = facts_.lists.try_emplace(name, std::move(list));
    if (!is_new) {
      fail_in_source(fmt::format("a second list '{}' of numbers", name), source_, list.line,
                     "give a file with one family");
    }
  }

  /// `codes[7] = 0x...;`
  bool read_item() {
    if (!is_kind(0, Kind::Word) || !peek(1).is("[") || !is_kind(2, Kind::Number) ||
        !peek(3).is("]") || !peek(4).is("=")) {
      return false;
    }
    std::size_t ahead = 5;
    const std::optional<std::uint64_t> value = number(ahead);
    if (!value || !peek(ahead).is(";")) return false;
    NumberList& list = facts_.lists[std::string(peek(0).text)];
    if (list.values.empty()) list.line = peek(0).line;
    const std::uint64_t index = token_number(peek(2), source_);
    if (index != list.values.size()) {
      fail_in_source(fmt::format("{}[{}] comes where {}[{}] is due", peek(0).text, index,
                                 peek(0).text, list.values.size()),
                     source_, peek(2).line, "list all items in their order, each once");
    }
    list.values.push_back(*value);
    list.lines.push_back(peek(5).line);
    at_ += ahead + 1;
    return true;
  }

  /// `tf->nbits = 36;`, `.nbits = 36,`, `tf->name = strdup("tag36h11");`
  bool read_field() {
    if (!peek(0).is(".") && !(peek(0).is("-") && peek(1).is(">"))) return false;
    const std::size_t name_at = peek(0).is(".") ? 1 : 2;
    if (!is_kind(name_at, Kind::Word) || !peek(name_at + 1).is("=")) return false;
    const std::string name(peek(name_at).text);
    const int line = peek(name_at).line;
    std::size_t ahead = name_at + 2;
    if (name == "name") {
      while (is_kind(ahead, Kind::Word) || peek(ahead).is("(") || peek(ahead).is(")") ||
             peek(ahead).is("*")) {
        ++ahead;
      }
      if (is_kind(ahead, Kind::Text)) set_name(std::string(peek(ahead).text), line);
      at_ += ahead;
      return true;
    }
    std::optional<std::uint64_t> value;
    if (peek(ahead).is("true") || peek(ahead).is("false")) {
      value = peek(ahead++).is("true");
    } else {
      value = number(ahead);
    }
    if (!value || (!peek(ahead).is(";") && !peek(ahead).is(",") && !peek(ahead).is("}"))) {
      return false;
    }
    const PlacedNumber placed{static_cast<std::int64_t>(*value), line};
    const auto [place, is_new] = facts_.fields.try_emplace(name, placed);
    if (!is_new && place->second.value != placed.value) {
      fail_in_source(
          fmt::format("'{}' is set to {} and to {}", name, place->second.value, placed.value),
          source_, line, "give a file with one family");
    }
    at_ += ahead;
    return true;
  }

  void set_name(const std::string& name, int line) {
    if (!facts_.name.empty() && facts_.name != name) {
      fail_in_source(fmt::format("two families, '{}' and '{}'", facts_.name, name), source_, line,
                     "give a file with one family");
    }
    facts_.name = name;
  }

  /// `TagCodes(36, 11, ...)` of the C++ tables, `super(36, 11, ...)` of the Java ones.
  bool read_table_head() {
    if (!is_kind(0, Kind::Word) || !peek(1).is("(") || !is_kind(2, Kind::Number) ||
        !peek(3).is(",") || !is_kind(4, Kind::Number) || !peek(5).is(",")) {
      return false;
    }
    if (!peek(0).is("TagCodes") && !peek(0).is("super") && !peek(0).text.starts_with("tagCodes")) {
      return false;
    }
    const auto placed = [this](std::size_t ahead) {
      return PlacedNumber{static_cast<std::int64_t>(token_number(peek(ahead), source_)),
                          peek(ahead).line};
    };
    facts_.table_bits = placed(2);
    facts_.table_distance = placed(4);
    at_ += 6;
    return true;
  }

  /// `tag36h11_create(`, `class Tag36h11`
  bool read_name() {
    if (!is_kind(0, Kind::Word)) return false;
    constexpr std::string_view kEnd = "_create";
    const std::string_view word = peek(0).text;
    if (word.size() > kEnd.size() && word.ends_with(kEnd) && peek(1).is("(")) {
      created_name_ = word.substr(0, word.size() - kEnd.size());
    } else if (created_name_.empty() && word == "class" && is_kind(1, Kind::Word)) {
      created_name_ = peek(1).text;
    } else {
      return false;
    }
    ++at_;
    return true;
  }

  const FamilySource& source_;
  std::vector<SourceToken> tokens_;
  std::size_t at_ = 0;
  SourceFacts facts_;
  std::string created_name_;
};

}  // namespace

SourceFacts collect_source_facts(const FamilySource& source) { return Collector(source).collect(); }

}  // namespace tagmint::io
