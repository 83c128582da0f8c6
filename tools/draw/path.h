#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tagmint::draw {

/// A place on a page in mm, or on a path in the path's own unit; x right, y down.
struct PathPoint {
  double x = 0.0;
  double y = 0.0;
  friend bool operator==(const PathPoint&, const PathPoint&) = default;
};

/// Where a path stands on the page, and how long its unit is there.
struct Placement {
  double x_mm = 0.0;
  double y_mm = 0.0;
  double unit_mm = 1.0;

  PathPoint on_page(const PathPoint& point) const {
    return {x_mm + unit_mm * point.x, y_mm + unit_mm * point.y};
  }
};

/// Contours of straight lines and cubic curves. Filled, a path covers what its contours wind around
/// a number of times that is not zero, so a contour that runs the other way round cuts a hole.
class Path {
 public:
  enum class Step : std::uint8_t { Move, Line, Curve, Close };

  void move_to(double x, double y);
  void line_to(double x, double y);
  /// A cubic curve to (x, y); the first two points are its controls.
  void curve_to(double x1, double y1, double x2, double y2, double x, double y);
  void close();

  /// A closed polygon through the points, in their order.
  void add_polygon(std::span<const PathPoint> corners);
  /// Clockwise as seen (y down).
  void add_rectangle(double x, double y, double width, double height);
  /// Clockwise; four curves, farther than a true circle by at most 0.03 % of the radius.
  void add_circle(double x, double y, double radius);
  /// Clockwise; the radius of its corners is at most half the shorter side.
  void add_rounded_rectangle(double x, double y, double width, double height, double radius);
  /// All contours of another path.
  void append(const Path& other);
  /// An open line.
  void add_line(double x0, double y0, double x1, double y1);

  bool empty() const { return steps_.empty(); }
  std::span<const Step> steps() const { return steps_; }
  /// The points of all steps in a row: one of a Move or Line, three of a Curve, none of a Close.
  std::span<const PathPoint> points() const { return points_; }

 private:
  std::vector<Step> steps_;
  std::vector<PathPoint> points_;
};

/// A rectangle that holds all points of a path.
struct PathBounds {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;
};

/// Bounds of the path's points (controls of curves included); all 0 for an empty path.
PathBounds bounds(const Path& path);

/// Calls `visit(step, points)` for each step, with the points that it has.
template <typename Visit>
void for_each_step(const Path& path, Visit visit) {
  const PathPoint* at = path.points().data();
  for (const Path::Step step : path.steps()) {
    visit(step, at);
    at += step == Path::Step::Curve ? 3 : (step == Path::Step::Close ? 0 : 1);
  }
}

/// A contour as a chain of straight lines.
struct Polyline {
  std::vector<PathPoint> points;
  bool closed = false;
};

/// The contours of a path with its curves cut into straight pieces that leave them by at most
/// `tolerance` (in the path's unit, > 0).
std::vector<Polyline> flattened(const Path& path, double tolerance);

}  // namespace tagmint::draw
