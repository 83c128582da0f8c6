#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/family_kinds/family_source.h"
#include "tagmint/codec/family.h"
#include "tagmint/codec/layout.h"

namespace tagmint::io {

/// How the bits of a list of codewords are ordered where the file does not say it.
enum class BitOrder {
  AsRecognised,   ///< what the kind's reader makes of the file
  QuarterBlocks,  ///< the layout's walk (docs/layouts.md)
  Rows,           ///< row by row over the data square, the lowest bit at the bottom right
};

/// The major version of OpenCV that a dictionary is for. OpenCV 4 has its own AprilTag dictionaries
/// turned by 180 degrees against the printed tags, OpenCV 5 has them upright.
enum class OpenCvTurn { HalfTurned = 4, Upright = 5 };

/// What the user says about an input, where the input does not say it itself.
struct FamilyReadOptions {
  std::string name = {};                        ///< of the family; empty = as the input says
  std::optional<codec::Layout> layout = {};     ///< of kinds that may leave it open
  std::optional<int> min_hamming = {};          ///< else declared by the input, or computed
  BitOrder bit_order = BitOrder::AsRecognised;  ///< of C sources
  std::optional<OpenCvTurn> opencv = {};        ///< of OpenCV dictionaries
  int threads = 0;                              ///< for computing distances; 0 = all cores
};

/// How a family is written.
struct FamilyWriteOptions {
  OpenCvTurn opencv = OpenCvTurn::HalfTurned;  ///< of OpenCV dictionaries
  std::size_t codes_before_cut = 0;  ///< of the family of which the one written is a part, else 0
};

/// A family as it was read, and what the user should know about how: whole sentences.
struct ReadFamily {
  codec::Family family;
  std::vector<std::string> notes = {};
};

/// A file to be written.
struct FamilyFile {
  std::string path;
  std::string content;
};

/// One kind of files that hold a family; family_kinds() lists them.
struct FamilyKind {
  std::string_view name;                          ///< as --to and --from have it
  std::string_view summary;                       ///< one line
  std::vector<std::string_view> extensions = {};  ///< of outputs, lower case, with the dot
  bool is_folder = false;                         ///< one file a tag in a folder of its own
  bool one_file = true;                           ///< could go to stdout
  bool holds_generators = false;       ///< could hold a family whose codewords are not listed
  std::size_t most_codes = 0;          ///< that the kind can hold; 0 = any number
  std::string_view limit_reason = {};  ///< why not more: "libapriltag holds no more"

  /// Whether the content (or folder) is of this kind; looks at marks, not at the whole.
  bool (*recognises)(const FamilySource& source) = nullptr;
  /// Throws codec::InputError with file and line for what is malformed, std::invalid_argument for
  /// options that contradict the input.
  ReadFamily (*read)(const FamilySource& source, const FamilyReadOptions& options) = nullptr;
  /// The files of `family`, whose codewords are listed unless the kind holds generators, where the
  /// output is called `target`. Throws std::invalid_argument with the reason for what the kind
  /// cannot hold.
  std::vector<FamilyFile> (*make)(const codec::Family& family, const std::string& target,
                                  const FamilyWriteOptions& options) = nullptr;
};

/// All kinds, in the order in which inputs are tried.
std::span<const FamilyKind> family_kinds();

/// Their names.
std::vector<std::string> family_kind_names();

/// The kind of that name, or null.
const FamilyKind* find_family_kind(std::string_view name);

/// The kind that an output's extension names, or null. A name without extension, or one that ends
/// in '/', is a folder.
const FamilyKind* family_kind_of_output(const std::string& target);

/// The kind of an input by its content. Throws codec::InputError when it is none.
const FamilyKind& recognise_family_kind(const FamilySource& source);

/// Writes the files of a family: each whole or not at all, a folder with all of them or not at all.
/// Throws codec::OutputError.
void write_family_files(const FamilyKind& kind, const std::string& target,
                        const std::vector<FamilyFile>& files);

}  // namespace tagmint::io
