#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/row_writer.h"

namespace tagmint::io {

/// Throws std::invalid_argument for a format that cannot be.
void check_row_format(const RowFormat& format);

/// The bytes that files hold of a row: packed bits with white as 1, gray levels, or pairs of black
/// and its opacity.
std::vector<std::uint8_t> row_samples(std::span<const std::uint8_t> gray, const RowFormat& format);

}  // namespace tagmint::io
