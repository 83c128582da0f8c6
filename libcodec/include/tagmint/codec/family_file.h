#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "tagmint/codec/export.h"
#include "tagmint/codec/family.h"

namespace tagmint::codec {

/// SHA-256 over the codewords in id order, each as 16 lowercase hex digits and a newline; 64 hex
/// digits. Computed, also where the family declares one. Cost: some 0.1 us a codeword.
TAGMINT_API std::string family_digest(const Family& family);

/// Reads the JSON text of a family file (docs/family-format.md). Unknown keys are ignored.
///   source   name used in messages, for example the path
/// Throws InputError naming source, line and fault: not JSON, wrong format or version, a missing
/// key or one of the wrong kind, a bad layout, counts, widths, duplicates, levels, a bad generator,
/// the digest of listed codewords. That of generated ones is believed (Family::declared_digest()).
TAGMINT_API Family parse_family(std::string_view json, const std::string& source);

/// Reads a family file. Throws InputError as parse_family() does, and when the file cannot be read.
TAGMINT_API Family read_family(const std::filesystem::path& path);

/// The JSON text of a family file, one codeword, or one word of the generator, a line.
TAGMINT_API std::string format_family(const Family& family);

/// Writes a family file beside `path` and renames it into place: whole or not at all. Throws
/// OutputError.
TAGMINT_API void write_family(const Family& family, const std::filesystem::path& path);

}  // namespace tagmint::codec
