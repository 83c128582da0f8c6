#pragma once

#include <cstdint>

namespace tagmint::detect {

/// out[i] = mean, rounded, of the two pixels 2 i and 2 i + 1 of both rows.
///   pixels   of the result
///   cost     a pass over both rows, a vector at a time
void halve_rows(const std::uint8_t* upper, const std::uint8_t* lower, int pixels,
                std::uint8_t* out);

namespace scalar {

/// The same, a pixel at a time.
void halve_rows(const std::uint8_t* upper, const std::uint8_t* lower, int pixels,
                std::uint8_t* out);

}  // namespace scalar

}  // namespace tagmint::detect
