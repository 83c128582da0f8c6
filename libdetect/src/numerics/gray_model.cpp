#include "numerics/gray_model.h"

#include <algorithm>

#include "numerics/small_matrix.h"

namespace tagmint::detect {

void GrayModel::add(Point p, double gray) {
  ++samples_;
  xx_ += p.x * p.x;
  xy_ += p.x * p.y;
  yy_ += p.y * p.y;
  x_ += p.x;
  y_ += p.y;
  xg_ += p.x * gray;
  yg_ += p.y * gray;
  g_ += gray;
  gg_ += gray * gray;
}

std::optional<GrayPlane> GrayModel::fit() const {
  if (samples_ < 3) return std::nullopt;
  const Matrix3 normal = {xx_, xy_, x_, xy_, yy_, y_, x_, y_, double(samples_)};
  const std::optional<Vector3> plane = solve(normal, {xg_, yg_, g_});
  if (!plane) return std::nullopt;
  return GrayPlane{(*plane)[0], (*plane)[1], (*plane)[2]};
}

double GrayModel::squared_residuals(const GrayPlane& fitted) const {
  // At the least-squares plane the residuals are orthogonal to it: only the part of g^2 that the
  // plane does not explain is left, rounding aside.
  return std::max(0.0, gg_ - fitted.cx * xg_ - fitted.cy * yg_ - fitted.c0 * g_);
}

}  // namespace tagmint::detect
