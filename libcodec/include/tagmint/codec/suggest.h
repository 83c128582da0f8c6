#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "tagmint/codec/export.h"

namespace tagmint::codec {

/// Of `names`, the one that a misspelt `word` most likely meant: the smallest number of
/// single-character inserts, deletes, replacements and swaps of neighbours, case ignored, at most a
/// third of the word's length (at least 1). Nothing when none is that near. Ties go to the first.
/// Cost: O(names * length^2).
TAGMINT_API std::optional<std::string> nearest_name(std::string_view word,
                                                    std::span<const std::string> names);

/// "; did you mean 'X'?" without the leading semicolon, or an empty string.
TAGMINT_API std::string did_you_mean(std::string_view word, std::span<const std::string> names);

}  // namespace tagmint::codec
