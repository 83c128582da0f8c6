#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tagmint/codec/export.h"
#include "tagmint/codec/family.h"

namespace tagmint::codec {

/// Names of the families compiled into the library (those of families/*.json), in the order of that
/// folder's README.
TAGMINT_API std::span<const std::string> family_names();

/// The bundled family of that exact name, or null. Parsed at the first request and then shared;
/// thread-safe.
TAGMINT_API SharedFamily find_family(std::string_view name);

/// A bundled name or, where it is none, the path of a family file.
/// Throws InputError: the file's fault as read_family(), or, for what is neither, a line with the
/// nearest name.
TAGMINT_API SharedFamily load_family(const std::string& name_or_path);

}  // namespace tagmint::codec
