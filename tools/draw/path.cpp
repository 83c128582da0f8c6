#include "draw/path.h"

#include <algorithm>
#include <cmath>

namespace tagmint::draw {
namespace {

/// Distance of a quarter circle's controls from its ends, for radius 1: the curve passes through
/// the middle of the arc.
constexpr double kQuarter = 0.5522847498307936;

PathPoint cubic_at(const PathPoint& start, const PathPoint* control, double t) {
  const double s = 1 - t;
  const double a = s * s * s;
  const double b = 3 * s * s * t;
  const double c = 3 * s * t * t;
  const double d = t * t * t;
  return {a * start.x + b * control[0].x + c * control[1].x + d * control[2].x,
          a * start.y + b * control[0].y + c * control[1].y + d * control[2].y};
}

/// Straight pieces that a cubic needs: the chord of a piece 1/n of it leaves it by at most 1/8 of
/// the largest second derivative over n^2.
int pieces_of_cubic(const PathPoint& start, const PathPoint* control, double tolerance) {
  const double bend = std::max(std::hypot(start.x - 2 * control[0].x + control[1].x,
                                          start.y - 2 * control[0].y + control[1].y),
                               std::hypot(control[0].x - 2 * control[1].x + control[2].x,
                                          control[0].y - 2 * control[1].y + control[2].y));
  constexpr double kMostPieces = 1000;
  return static_cast<int>(
      std::clamp(std::ceil(std::sqrt(6 * bend / (8 * tolerance))), 1.0, kMostPieces));
}

}  // namespace

void Path::move_to(double x, double y) {
  steps_.push_back(Step::Move);
  points_.push_back({x, y});
}

void Path::line_to(double x, double y) {
  steps_.push_back(Step::Line);
  points_.push_back({x, y});
}

void Path::curve_to(double x1, double y1, double x2, double y2, double x, double y) {
  steps_.push_back(Step::Curve);
  points_.insert(points_.end(), {{x1, y1}, {x2, y2}, {x, y}});
}

void Path::close() { steps_.push_back(Step::Close); }

void Path::add_polygon(std::span<const PathPoint> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i == 0) {
      move_to(corners[i].x, corners[i].y);
    } else {
      line_to(corners[i].x, corners[i].y);
    }
  }
  if (!corners.empty()) close();
}

void Path::add_rectangle(double x, double y, double width, double height) {
  const PathPoint corners[] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
  add_polygon(corners);
}

void Path::add_circle(double x, double y, double radius) {
  add_rounded_rectangle(x - radius, y - radius, 2 * radius, 2 * radius, radius);
}

void Path::add_rounded_rectangle(double x, double y, double width, double height, double radius) {
  const double r = std::min({radius, width / 2, height / 2});
  const double near = r * (1 - kQuarter);  // from the corner to a control
  const double right = x + width;
  const double bottom = y + height;
  const bool flat = width > 2 * r;
  const bool tall = height > 2 * r;
  move_to(x + r, y);
  if (flat) line_to(right - r, y);
  curve_to(right - near, y, right, y + near, right, y + r);
  if (tall) line_to(right, bottom - r);
  curve_to(right, bottom - near, right - near, bottom, right - r, bottom);
  if (flat) line_to(x + r, bottom);
  curve_to(x + near, bottom, x, bottom - near, x, bottom - r);
  if (tall) line_to(x, y + r);
  curve_to(x, y + near, x + near, y, x + r, y);
  close();
}

void Path::append(const Path& other) {
  steps_.insert(steps_.end(), other.steps_.begin(), other.steps_.end());
  points_.insert(points_.end(), other.points_.begin(), other.points_.end());
}

void Path::add_line(double x0, double y0, double x1, double y1) {
  move_to(x0, y0);
  line_to(x1, y1);
}

PathBounds bounds(const Path& path) {
  if (path.points().empty()) return {};
  const PathPoint first = path.points().front();
  PathBounds box{first.x, first.y, first.x, first.y};
  for (const PathPoint& point : path.points()) {
    box.left = std::min(box.left, point.x);
    box.top = std::min(box.top, point.y);
    box.right = std::max(box.right, point.x);
    box.bottom = std::max(box.bottom, point.y);
  }
  return box;
}

std::vector<Polyline> flattened(const Path& path, double tolerance) {
  std::vector<Polyline> lines;
  for_each_step(path, [&](Path::Step step, const PathPoint* points) {
    if (step == Path::Step::Move) {
      lines.push_back({.points = {points[0]}, .closed = false});
      return;
    }
    if (lines.empty()) return;
    std::vector<PathPoint>& chain = lines.back().points;
    if (step == Path::Step::Close) {
      lines.back().closed = true;
      if (chain.size() > 1 && chain.front() == chain.back()) chain.pop_back();
    } else if (step == Path::Step::Line) {
      chain.push_back(points[0]);
    } else {
      const PathPoint start = chain.back();
      const int pieces = pieces_of_cubic(start, points, tolerance);
      for (int i = 1; i < pieces; ++i) {
        chain.push_back(cubic_at(start, points, static_cast<double>(i) / pieces));
      }
      chain.push_back(points[2]);
    }
  });
  return lines;
}

}  // namespace tagmint::draw
