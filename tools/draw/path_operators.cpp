#include "draw/path_operators.h"

#include "draw/numbers.h"

namespace tagmint::draw {

void append_path_operators(std::string& out, const Path& path, int digits) {
  const auto put = [&](const PathPoint& point) {
    append_number(out, point.x, digits);
    out += ' ';
    append_number(out, point.y, digits);
    out += ' ';
  };
  for_each_step(path, [&](Path::Step step, const PathPoint* points) {
    switch (step) {
      case Path::Step::Move:
        put(points[0]);
        out += "m\n";
        return;
      case Path::Step::Line:
        put(points[0]);
        out += "l\n";
        return;
      case Path::Step::Curve:
        for (int i = 0; i < 3; ++i) put(points[i]);
        out += "c\n";
        return;
      case Path::Step::Close:
        out += "h\n";
        return;
    }
  });
}

}  // namespace tagmint::draw
