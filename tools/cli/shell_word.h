#pragma once

#include <string>
#include <string_view>

namespace tagmint::cli {

/// The text as one word of a POSIX shell: quoted where it needs that.
std::string shell_word(std::string_view text);

}  // namespace tagmint::cli
