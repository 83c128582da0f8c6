#include "support/glued_poster.h"

#include <algorithm>
#include <cmath>

namespace tagmint::test {

detect::Image glued_poster(const poster::PosterPlan& plan, const std::vector<detect::Image>& pages,
                           double px_a_mm) {
  const auto px = [px_a_mm](double mm) { return static_cast<int>(std::lround(mm * px_a_mm)); };
  const int side = px(plan.side_mm);
  detect::Image poster(side, side, 128);  // what no page covers stays gray
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const draw::Box& part = plan.pages[i].part;
    const int left = px(part.x_mm);
    const int top = px(part.y_mm);
    const int margin = px(plan.margin_mm);
    for (int y = std::max(top, 0); y < std::min(px(part.bottom_mm()), side); ++y) {
      for (int x = std::max(left, 0); x < std::min(px(part.right_mm()), side); ++x) {
        poster.at(x, y) = pages[i].at(x - left + margin, y - top + margin);
      }
    }
  }
  return poster;
}

}  // namespace tagmint::test
