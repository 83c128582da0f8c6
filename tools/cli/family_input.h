#pragma once

#include <string>
#include <vector>

#include "io/family_kinds/family_kind.h"
#include "tagmint/codec/family.h"

namespace CLI {
class App;
}

namespace tagmint::cli {

/// A family that a command was given, in whatever form.
struct InputFamily {
  codec::SharedFamily family;
  std::vector<std::string> notes;  ///< what the user should know about how it was read
  /// Not bundled and no tagmint file: other commands take it after `tagmint convert`.
  bool foreign = false;
};

/// The family of `name`: a bundled one, that of a file or folder of any kind that `convert` reads,
/// or an older system. A bundled name goes before a file of that name.
///   from   name of the file's kind; empty = by its content
/// Throws codec::InputError, UsageError, std::invalid_argument for options that contradict it.
InputFamily read_input_family(const std::string& name, const io::FamilyReadOptions& options,
                              const std::string& from = {});

/// Adds the required positional FAMILY of the commands that read every kind, and --from, which
/// names the kind.
void add_any_family(CLI::App& app, std::string& name, std::string& from);

}  // namespace tagmint::cli
