#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// A value and the line of the file that it stands on, counted from 1.
template <typename T>
struct Placed {
  T value{};
  int line = 0;
};

/// One entry of "levels" as the file has it.
struct LevelEntry {
  std::optional<Placed<std::uint64_t>> codes;
  std::optional<Placed<std::uint64_t>> min_hamming;
  std::optional<Placed<std::uint64_t>> plain;
};

/// One entry of "levels" in "generator" as the file has it.
struct GeneratorLevelEntry {
  std::optional<Placed<std::uint64_t>> dimension;
  std::optional<Placed<std::uint64_t>> cosets;
};

/// "generator" as the file has it.
struct GeneratorEntry {
  std::optional<std::vector<Codeword>> basis;
  std::optional<Codeword> translation;
  std::optional<std::vector<Codeword>> cosets;
  std::optional<std::vector<GeneratorLevelEntry>> levels;
};

/// The known keys of a family file with their lines. Each value has the right kind; whether they
/// fit together is for build_family() to say.
struct FamilyDocument {
  std::optional<Placed<std::string>> format;
  std::optional<Placed<std::uint64_t>> version;
  std::optional<Placed<std::string>> name;
  std::optional<Placed<std::uint64_t>> bits;
  std::optional<Placed<std::uint64_t>> min_hamming;
  std::optional<Placed<std::vector<std::string>>> layout;
  std::optional<Placed<std::string>> complexity_rule;
  std::optional<Placed<double>> complexity_threshold;
  std::string origin_method, origin_order, origin_seed, origin_searched, origin_program;
  std::optional<Placed<std::string>> sha256;
  std::optional<Placed<std::vector<Codeword>>> codes;
  std::vector<int> code_lines;  // of each codeword
  std::optional<Placed<std::vector<LevelEntry>>> levels;
  std::optional<Placed<GeneratorEntry>> generator;
  int last_line = 1;
};

/// Reads the JSON text. Unknown keys are passed over, whatever they hold.
/// Throws InputError naming source and line: not JSON, a known key twice or with a value of the
/// wrong kind, a codeword that is not "0x" and 16 hex digits.
FamilyDocument parse_family_document(std::string_view json, const std::string& source);

/// Throws the InputError of a fault in that line: "WHAT (source:line); MEND".
[[noreturn]] void fail_in_line(std::string_view what, const std::string& source, int line,
                               std::string_view mend);

}  // namespace tagmint::codec
