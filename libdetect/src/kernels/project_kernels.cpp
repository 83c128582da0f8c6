#include "kernels/project_kernels.h"

#include <cmath>

// Highway compiles this file once for each set of instructions. All of them give the same floats,
// since products and sums are not contracted (see CMakeLists.txt).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/project_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tagmint::detect {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kProjectPadding>;
using Whole = hn::Repartition<std::int32_t, Floats>;

HWY_ATTR void project_row(const ProjectiveFloats& map, const float* u, float v, int count,
                          const PixelPlaces& places) {
  const Floats d;
  const Whole di;
  const auto x_u = hn::Set(d, map[0]), x_1 = hn::Set(d, map[1] * v + map[2]);
  const auto y_u = hn::Set(d, map[3]), y_1 = hn::Set(d, map[4] * v + map[5]);
  const auto w_u = hn::Set(d, map[6]), w_1 = hn::Set(d, map[7] * v + map[8]);
  const auto one = hn::Set(d, 1.0f);
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
    const auto at = hn::LoadU(d, u + i);
    const auto scale = hn::Div(one, hn::Add(hn::Mul(w_u, at), w_1));
    const auto x = hn::Mul(hn::Add(hn::Mul(x_u, at), x_1), scale);
    const auto y = hn::Mul(hn::Add(hn::Mul(y_u, at), y_1), scale);
    const auto whole_x = hn::Floor(x), whole_y = hn::Floor(y);
    hn::StoreU(hn::ConvertTo(di, whole_x), di, places.x + i);
    hn::StoreU(hn::ConvertTo(di, whole_y), di, places.y + i);
    hn::StoreU(hn::Sub(x, whole_x), d, places.fx + i);
    hn::StoreU(hn::Sub(y, whole_y), d, places.fy + i);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace tagmint::detect
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tagmint::detect {

void scalar::project_row(const ProjectiveFloats& map, const float* u, float v, int count,
                         const PixelPlaces& places) {
  for (int i = 0; i < count; ++i) {
    const float scale = 1.0f / (map[6] * u[i] + (map[7] * v + map[8]));
    const float x = (map[0] * u[i] + (map[1] * v + map[2])) * scale;
    const float y = (map[3] * u[i] + (map[4] * v + map[5])) * scale;
    places.x[i] = static_cast<std::int32_t>(std::floor(x));
    places.y[i] = static_cast<std::int32_t>(std::floor(y));
    places.fx[i] = x - std::floor(x);
    places.fy[i] = y - std::floor(y);
  }
}

HWY_EXPORT(project_row);

void project_row(const ProjectiveFloats& map, const float* u, float v, int count,
                 const PixelPlaces& places) {
  HWY_DYNAMIC_DISPATCH(project_row)(map, u, v, count, places);
}

}  // namespace tagmint::detect
#endif
