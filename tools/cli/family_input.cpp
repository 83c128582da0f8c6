#include "cli/family_input.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

#include "cli/command.h"
#include "cli/options.h"
#include "io/family_kinds/family_changes.h"
#include "io/family_kinds/older_systems.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/suggest.h"

namespace tagmint::cli {
namespace {

[[noreturn]] void throw_unknown_input(const std::string& name) {
  const std::span<const std::string> bundled = codec::family_names();
  std::vector<std::string> names(bundled.begin(), bundled.end());
  for (std::string& older : io::older_system_names()) names.push_back(std::move(older));
  std::string hint = codec::did_you_mean(name, names);
  if (!hint.empty()) hint += ' ';
  throw codec::InputError(fmt::format("no family '{}' is bundled and no file has that name", name),
                          "", hint + "`tagmint families` lists the bundled ones");
}

InputFamily input_of(io::ReadFamily read, bool foreign) {
  return {std::make_shared<const codec::Family>(std::move(read.family)), std::move(read.notes),
          foreign};
}

}  // namespace

InputFamily read_input_family(const std::string& name, const io::FamilyReadOptions& options,
                              const std::string& from) {
  if (const auto bundled = from.empty() ? codec::find_family(name) : nullptr) {
    return input_of({io::with_options(*bundled, options)}, false);
  }
  std::error_code unknown;
  if (name != "-" && !std::filesystem::exists(name, unknown)) {
    if (auto older = io::find_older_system(name, options)) return input_of(std::move(*older), true);
    throw_unknown_input(name);
  }
  const io::FamilySource source = io::read_family_source(name);
  const io::FamilyKind& kind =
      from.empty() ? io::recognise_family_kind(source) : *io::find_family_kind(from);
  if (source.is_folder != kind.is_folder) {
    throw UsageError(fmt::format("a {} is not {}", source.is_folder ? "folder" : "file", kind.name),
                     name, "leave --from out");
  }
  return input_of(kind.read(source, options), kind.name != "tagmint");
}

void add_any_family(CLI::App& app, std::string& name, std::string& from) {
  app.add_option("FAMILY", name,
                 "bundled family, file or folder of any kind that convert reads, or older system")
      ->required();
  add_choice(app, "--from", from, io::family_kind_names(), "kind of the file; else by its content")
      ->type_name("KIND");
}

}  // namespace tagmint::cli
