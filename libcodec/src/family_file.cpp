#include "tagmint/codec/family_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <system_error>
#include <vector>

#include "codeword_digest.h"
#include "family_builder.h"
#include "family_document.h"
#include "tagmint/codec/atomic_file.h"
#include "tagmint/codec/errors.h"

namespace tagmint::codec {
namespace {

std::string quote(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Items one a line, indented.
std::string one_a_line(const std::vector<std::string>& items, int indent = 4) {
  const std::string spaces(indent, ' ');
  return fmt::format("{}{}", spaces, fmt::join(items, ",\n" + spaces));
}

/// The two keys that hold the codewords and their digest, up to the end of the family's object.
std::string codes_text(const Family& family) {
  std::vector<std::string> codes;
  for (const Codeword word : family.codewords()) codes.push_back(quote(to_hex(word)));
  return fmt::format("  \"sha256\":\"{}\",\n  \"codes\":[\n{}\n  ]\n", family_digest(family),
                     one_a_line(codes));
}

std::string generator_text(const Family& family) {
  const RotationCode& code = *family.generator();
  const auto hex_lines = [](std::span<const Codeword> words) {
    std::vector<std::string> lines;
    for (const Codeword word : words) lines.push_back(quote(to_hex(word)));
    return one_a_line(lines, 6);
  };
  std::vector<std::string> levels;
  for (const RotationCodeLevel& level : code.levels()) {
    levels.push_back(
        fmt::format("{{\"dimension\":{},\"cosets\":{}}}", level.dimension, level.cosets));
  }
  const std::string digest =
      family.declared_digest().empty() ? family_digest(family) : family.declared_digest();
  return fmt::format(
      "  \"sha256\":{},\n"
      "  \"generator\":{{\n"
      "    \"basis\":[\n{}\n    ],\n"
      "    \"translation\":\"{}\",\n"
      "    \"cosets\":[\n{}\n    ],\n"
      "    \"levels\":[\n{}\n    ]\n"
      "  }}\n",
      quote(digest), hex_lines(code.basis()), to_hex(code.translation()), hex_lines(code.cosets()),
      one_a_line(levels, 6));
}

std::string levels_text(std::span<const Level> levels) {
  std::vector<std::string> lines;
  for (const Level& level : levels) {
    const std::string plain =
        level.plain == 0 ? std::string() : fmt::format(",\"plain\":{}", level.plain);
    lines.push_back(fmt::format("{{\"codes\":{},\"min_hamming\":{}{}}}", level.codes,
                                level.min_hamming, plain));
  }
  return fmt::format("  \"levels\":[\n{}\n  ],\n", one_a_line(lines));
}

}  // namespace

std::string family_digest(const Family& family) {
  constexpr std::size_t kWordsAtATime = 1 << 16;
  CodewordDigest digest;
  for (std::size_t id = 0; id < family.size(); id += kWordsAtATime) {
    digest.add(some_codewords(family, static_cast<TagId>(id), kWordsAtATime));
  }
  return digest.hex();
}

Family parse_family(std::string_view json, const std::string& source) {
  return build_family(parse_family_document(json, source), source);
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
  const Complexity& complexity = family.complexity();
  const std::string threshold = complexity.rule == ComplexityRule::None
                                    ? std::string()
                                    : fmt::format(",\"threshold\":{}", complexity.threshold);
  const Origin& origin = family.origin();
  // A single level without plain tags is what a reader takes where there are none.
  const bool has_levels = family.levels().size() > 1 || family.levels()[0].plain > 0;
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
      "{}{}"
      "}}\n",
      kFamilyFormat, kFamilyVersion, quote(family.name()), family.bits(), family.min_hamming(),
      one_a_line(rows), rule_name(complexity.rule), threshold, quote(origin.method),
      quote(origin.order), quote(origin.seed), quote(origin.searched), quote(origin.program),
      has_levels ? levels_text(family.levels()) : std::string(),
      family.is_listed() ? codes_text(family) : generator_text(family));
}

void write_family(const Family& family, const std::filesystem::path& path) {
  write_file_atomically(path, format_family(family));
}

}  // namespace tagmint::codec
