#pragma once

#include <string>
#include <string_view>

namespace tagmint::io {

/// An input that holds a family: the bytes of a file, or a folder.
struct FamilySource {
  std::string path;     ///< as the user gave it
  std::string name;     ///< as messages call it
  std::string content;  ///< of a file, unpacked; empty for a folder
  bool is_folder = false;
};

/// Reads a file ("-" is the standard input) and unpacks it if it is a gzip file; of a folder only
/// the name is kept. Throws codec::InputError with the reason.
FamilySource read_family_source(const std::string& path);

/// A name for a family that its input does not name: the file's name without its extensions, with
/// '_' for what names of families cannot hold; "family" where nothing is left.
std::string name_from_path(const FamilySource& source);

/// The text with '_' for the characters that names of families cannot hold.
std::string possible_name(std::string_view text);

/// Throws the codec::InputError "WHAT (SOURCE:LINE); MEND"; what a text quotes is made printable.
///   line   from 1; 0 = of no line
[[noreturn]] void fail_in_source(std::string_view what, const FamilySource& source, int line,
                                 std::string_view mend);

}  // namespace tagmint::io
