#pragma once

#include <span>
#include <string_view>

namespace tagmint::codec {

/// A family file compiled into the library.
struct EmbeddedFamily {
  std::string_view name;
  std::string_view json;
};

/// All of them, in the order of libcodec/CMakeLists.txt. Defined in a source that
/// cmake/embed_families.cmake writes.
std::span<const EmbeddedFamily> embedded_families();

}  // namespace tagmint::codec
