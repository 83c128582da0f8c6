#include "tagmint/codec/family_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "family_document.h"
#include "family_rules.h"
#include "sha256.h"
#include "tagmint/codec/atomic_file.h"
#include "tagmint/codec/errors.h"

namespace tagmint::codec {
namespace {

constexpr std::string_view kFormat = "tagmint-family";
constexpr std::uint64_t kVersion = 1;

std::string digest_of(std::span<const Codeword> codewords) {
  std::string lines;
  lines.reserve(codewords.size() * 17);
  for (const Codeword word : codewords) {
    fmt::format_to(std::back_inserter(lines), "{:016x}\n", word);
  }
  return sha256_hex(lines);
}

/// Turns a document into a Family, telling each fault with its line.
class FamilyBuilder {
 public:
  FamilyBuilder(FamilyDocument document, const std::string& source)
      : document_(std::move(document)), source_(source) {}

  Family build() {
    check_kind();
    const std::string name = read_name();
    Layout layout = read_layout();
    const int min_hamming = read_min_hamming(layout.bits());
    std::vector<Codeword> codewords = read_codewords(layout.bits());
    std::vector<Level> levels = read_levels(codewords.size(), min_hamming);
    check_digest(codewords);
    return Family(
        {.name = name,
         .layout = std::move(layout),
         .min_hamming = min_hamming,
         .codewords = std::move(codewords),
         .complexity = read_complexity(),
         .origin = {document_.origin_method, document_.origin_order, document_.origin_seed,
                    document_.origin_searched, document_.origin_program},
         .levels = std::move(levels)});
  }

 private:
  [[noreturn]] void fail(int line, std::string_view what, std::string_view mend) const {
    fail_in_line(what, source_, line, mend);
  }

  /// The value of a key that must be there.
  template <typename T>
  const Placed<T>& need(const std::optional<Placed<T>>& value, std::string_view key) const {
    if (!value) {
      fail(document_.last_line, fmt::format("the key \"{}\" is missing", key),
           "see docs/family-format.md");
    }
    return *value;
  }

  /// Runs a check that throws std::invalid_argument and tells its message with the line.
  template <typename Check>
  auto checked(int line, Check check) const {
    try {
      return check();
    } catch (const std::invalid_argument& error) {
      fail(line, error.what(), "correct this line or make the file anew");
    }
  }

  void check_kind() const {
    if (!document_.format || document_.format->value != kFormat) {
      fail(document_.format ? document_.format->line : 1, "this is not a tagmint family file",
           fmt::format("its \"format\" must be \"{}\"", kFormat));
    }
    const Placed<std::uint64_t>& version = need(document_.version, "version");
    if (version.value != kVersion) {
      fail(version.line, fmt::format("family file version {} is unknown", version.value),
           fmt::format("this tagmint reads version {}", kVersion));
    }
  }

  std::string read_name() const {
    const Placed<std::string>& name = need(document_.name, "name");
    checked(name.line, [&] { check_family_name(name.value); });
    return name.value;
  }

  Layout read_layout() const {
    const Placed<std::vector<std::string>>& rows = need(document_.layout, "layout");
    Layout layout =
        checked(rows.line, [&] { return Layout(fmt::format("{}", fmt::join(rows.value, "/"))); });
    const Placed<std::uint64_t>& bits = need(document_.bits, "bits");
    if (bits.value != static_cast<std::uint64_t>(layout.bits())) {
      fail(bits.line,
           fmt::format("\"bits\" is {}, but the layout has {} data cells", bits.value,
                       layout.bits()),
           "correct one of them");
    }
    return layout;
  }

  int read_min_hamming(int bits) const {
    const Placed<std::uint64_t>& distance = need(document_.min_hamming, "min_hamming");
    const int min_hamming = to_int(distance.value);
    checked(distance.line, [&] { check_min_hamming(min_hamming, bits); });
    return min_hamming;
  }

  std::vector<Codeword> read_codewords(int bits) {
    if (document_.generator && !document_.codes) {
      fail(document_.generator->line, "the codewords are given by a \"generator\"",
           "this tagmint reads families whose \"codes\" are listed");
    }
    need(document_.codes, "codes");
    Placed<std::vector<Codeword>>& codes = *document_.codes;
    if (codes.value.empty()) fail(codes.line, "\"codes\" is empty", "list at least one codeword");
    if (codes.value.size() > std::numeric_limits<TagId>::max()) {
      fail(codes.line, fmt::format("{} codewords are more than ids can count", codes.value.size()),
           "split the family");
    }
    if (const auto fault = find_codeword_fault(codes.value, bits)) {
      fail(document_.code_lines[fault->id], fault->message, "correct or remove this codeword");
    }
    return std::move(codes.value);
  }

  std::vector<Level> read_levels(std::size_t size, int min_hamming) const {
    if (!document_.levels) return {};
    const auto& [entries, line] = *document_.levels;
    std::vector<Level> levels;
    for (const LevelEntry& entry : entries) {
      if (!entry.codes || !entry.min_hamming) {
        fail(line, fmt::format("level {} lacks \"codes\" or \"min_hamming\"", levels.size()),
             "each level has both");
      }
      levels.push_back({entry.codes->value, to_int(entry.min_hamming->value)});
    }
    checked(line, [&] { check_levels(levels, size, min_hamming); });
    return levels;
  }

  void check_digest(std::span<const Codeword> codewords) const {
    const Placed<std::string>& declared = need(document_.sha256, "sha256");
    const std::string found = digest_of(codewords);
    if (declared.value != found) {
      fail(declared.line, "the codewords are not those that \"sha256\" was made of",
           fmt::format("get the file anew or, if they are meant so, write {}", found));
    }
  }

  Complexity read_complexity() const {
    const auto& rule = document_.complexity_rule;
    const auto& threshold = document_.complexity_threshold;
    if (!rule && !threshold) return {};
    if (!rule) fail(threshold->line, "\"complexity\" has no \"rule\"", "name the rule");
    return checked(rule->line, [&] {
      if (!threshold || rule->value == "none") return parse_complexity(rule->value);
      return parse_complexity(fmt::format("{}:{}", rule->value, threshold->value));
    });
  }

  /// Numbers too large for an int become the largest one, which every check refuses.
  static int to_int(std::uint64_t number) {
    constexpr int most = std::numeric_limits<int>::max();
    return static_cast<int>(std::min<std::uint64_t>(number, most));
  }

  FamilyDocument document_;
  const std::string& source_;
};

std::string quote(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// `quoted` items, one a line, indented by four.
std::string one_a_line(const std::vector<std::string>& quoted) {
  return fmt::format("    {}", fmt::join(quoted, ",\n    "));
}

}  // namespace

std::string family_digest(const Family& family) { return digest_of(family.codewords()); }

Family parse_family(std::string_view json, const std::string& source) {
  return FamilyBuilder(parse_family_document(json, source), source).build();
}

Family read_family(const std::filesystem::path& path) {
  const std::string source = path.string();
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) {
    throw InputError("this is a folder", source, "give a family file");
  }
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  if (file.is_open() && file.peek() != std::ifstream::traits_type::eof()) content << file.rdbuf();
  if (!file.is_open() || file.bad() || content.fail()) {
    throw InputError("cannot read the family file", source,
                     "check that it exists and that you may read it");
  }
  return parse_family(content.view(), source);
}

std::string format_family(const Family& family) {
  std::vector<std::string> rows;
  for (const std::string& row : family.layout().rows()) rows.push_back(quote(row));
  std::vector<std::string> codes;
  for (const Codeword word : family.codewords()) codes.push_back(quote(to_hex(word)));

  const Complexity& complexity = family.complexity();
  const std::string threshold = complexity.rule == ComplexityRule::None
                                    ? std::string()
                                    : fmt::format(",\"threshold\":{}", complexity.threshold);
  const Origin& origin = family.origin();
  std::string levels;
  if (family.levels().size() > 1) {
    std::vector<std::string> lines;
    for (const Level& level : family.levels()) {
      lines.push_back(
          fmt::format("{{\"codes\":{},\"min_hamming\":{}}}", level.codes, level.min_hamming));
    }
    levels = fmt::format("  \"levels\":[\n{}\n  ],\n", one_a_line(lines));
  }
  return fmt::format(
      "{{\n"
      "  \"format\":\"{}\",\n"
      "  \"version\":{},\n"
      "  \"name\":{},\n"
      "  \"bits\":{},\n"
      "  \"min_hamming\":{},\n"
      "  \"layout\":[\n{}\n  ],\n"
      "  \"complexity\":{{\"rule\":\"{}\"{}}},\n"
      "  \"origin\":{{\"method\":{},\"order\":{},\"seed\":{},\"searched\":{},\"program\":{}}},\n"
      "{}"
      "  \"sha256\":\"{}\",\n"
      "  \"codes\":[\n{}\n  ]\n"
      "}}\n",
      kFormat, kVersion, quote(family.name()), family.bits(), family.min_hamming(),
      one_a_line(rows), rule_name(complexity.rule), threshold, quote(origin.method),
      quote(origin.order), quote(origin.seed), quote(origin.searched), quote(origin.program),
      levels, family_digest(family), one_a_line(codes));
}

void write_family(const Family& family, const std::filesystem::path& path) {
  write_file_atomically(path, format_family(family));
}

}  // namespace tagmint::codec
