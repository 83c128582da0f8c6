#pragma once

#include <array>
#include <cstdint>

namespace tagmint::detect {

/// A projective map with float entries, row-major, for places near the origin of both planes.
using ProjectiveFloats = std::array<float, 9>;

/// Where a row of points went: the pixel they are in, and how far into it.
struct PixelPlaces {
  std::int32_t* x;  ///< whole part
  std::int32_t* y;
  float* fx;  ///< the rest, 0 <= fx < 1
  float* fy;
};
/// Points are read and written up to the next multiple of this.
inline constexpr int kProjectPadding = 16;

/// Images of the points (u[i], v), 0 <= i < count.
///   map     its denominator must not be zero at any of them, padding included
///   cost    one division a point, a vector at a time; the same floats with every instruction set
void project_row(const ProjectiveFloats& map, const float* u, float v, int count,
                 const PixelPlaces& places);

namespace scalar {

/// The same, a point at a time.
void project_row(const ProjectiveFloats& map, const float* u, float v, int count,
                 const PixelPlaces& places);

}  // namespace scalar

}  // namespace tagmint::detect
