#include "tagmint/detect/geometry.h"

namespace tagmint::detect {

double signed_area(const Corners& corners) {
  double twice = 0;
  for (int i = 0; i < 4; ++i) twice += cross(corners[i], corners[(i + 1) % 4]);
  return twice / 2;
}

}  // namespace tagmint::detect
