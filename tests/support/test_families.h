#pragma once

#include <cstddef>
#include <string_view>

#include "tagmint/codec/family.h"

namespace tagmint::test {

/// A family of `size` tags with arbitrary codewords in the layout of that name: for tests of how
/// tags look, not of how far apart they are.
codec::SharedFamily arbitrary_family(std::string_view layout_name, std::size_t size = 8);

}  // namespace tagmint::test
