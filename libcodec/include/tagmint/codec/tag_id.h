#pragma once

#include <cstdint>

namespace tagmint::codec {

/// Index of a tag in its family. Families may hold more than 65,536 tags.
using TagId = std::uint32_t;

}  // namespace tagmint::codec
