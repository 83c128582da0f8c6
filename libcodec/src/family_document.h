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
};

/// The known keys of a family file with their lines. Each value has the right kind; whether they
/// fit together is for the reader (family_file.cpp) to say.
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
  std::optional<Placed<bool>> generator;  // set where the key is there; its content is not read
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
