#include "plot/panel.h"

#include <algorithm>
#include <numbers>

#include "plot/scale.h"

namespace tagmint::plot {
namespace {

constexpr double kLeft_px = 62;
constexpr double kRight_px = 14;
constexpr double kTop_px = 26;
constexpr double kBottom_px = 46;
constexpr double kTurnedBottom_px = 96;  // under names that are written aslant
constexpr double kText_px = 11;
constexpr double kTitle_px = 12.5;

/// A panel at work: its axes in the picture.
class Painter {
 public:
  Painter(Pen& pen, const Panel& panel, const Box& box)
      : pen_(pen),
        panel_(panel),
        box_(box),
        x_(panel.x, values(panel, true)),
        y_(panel.y, values(panel, false)) {
    slanted_ = panel.x.categories.size() > 4;
    plot_ = {box.left + kLeft_px, box.top + kTop_px, box.width - kLeft_px - kRight_px,
             box.height - kTop_px - (slanted_ ? kTurnedBottom_px : kBottom_px)};
  }

  void draw() {
    grid();
    marks();
    cairo_t* const context = pen_.context();
    cairo_save(context);
    // Markers on the frame are whole.
    constexpr double kRoom_px = 6;
    cairo_rectangle(context, plot_.left - kRoom_px, plot_.top - kRoom_px,
                    plot_.width + 2 * kRoom_px, plot_.height + 2 * kRoom_px);
    cairo_clip(context);
    for (const Series& series : panel_.series) draw_line(series);
    for (const Series& series : panel_.series) draw_markers(series);
    cairo_restore(context);
    for (const Series& series : panel_.series) draw_texts(series);
    frame();
  }

 private:
  static std::vector<double> values(const Panel& panel, bool of_x) {
    std::vector<double> all;
    for (const Series& series : panel.series) {
      for (const Spot& spot : series.spots) all.push_back(of_x ? spot.x : spot.y);
    }
    for (const Mark& mark : panel.marks) {
      if (mark.across != of_x) all.push_back(mark.at);
    }
    return all;
  }

  double across(double x) const { return plot_.left + x_.share(x) * plot_.width; }
  double up(double y) const { return plot_.bottom() - y_.share(y) * plot_.height; }
  bool shown(const Spot& spot) const { return x_.can_show(spot.x) && y_.can_show(spot.y); }

  void grid() {
    for (const Tick& tick : x_.ticks()) {
      const double x = across(tick.value);
      pen_.rule(x, plot_.top, x, plot_.bottom(), tick.text.empty() ? 0.93 : 0.86, 0.6);
      if (tick.text.empty()) continue;
      if (slanted_) {
        slanted_text(x, tick.text);
      } else {
        pen_.text(x, plot_.bottom() + 15, tick.text, kText_px, Align::Middle);
      }
    }
    for (const Tick& tick : y_.ticks()) {
      const double y = up(tick.value);
      pen_.rule(plot_.left, y, plot_.right(), y, tick.text.empty() ? 0.93 : 0.86, 0.6);
      if (!tick.text.empty()) {
        pen_.text(plot_.left - 6, y + 4, tick.text, kText_px, Align::Right);
      }
    }
  }

  void slanted_text(double x, const std::string& text) {
    cairo_t* const context = pen_.context();
    cairo_save(context);
    cairo_translate(context, x + 4, plot_.bottom() + 11);
    cairo_rotate(context, -std::numbers::pi / 4);
    pen_.text(0, 0, text, kText_px - 1, Align::Right);
    cairo_restore(context);
  }

  void marks() {
    for (const Mark& mark : panel_.marks) {
      if (mark.across) {
        const double y = up(mark.at);
        pen_.rule(plot_.left, y, plot_.right(), y, 0.35, 0.9);
        pen_.text(plot_.right() - 4, y - 4, mark.text, kText_px - 1, Align::Right);
      } else {
        const double x = across(mark.at);
        pen_.rule(x, plot_.top, x, plot_.bottom(), 0.35, 0.9);
        pen_.text(x - 4, plot_.bottom() - 6, mark.text, kText_px - 1, Align::Right);
      }
    }
  }

  void draw_line(const Series& series) {
    if (!series.line) return;
    cairo_new_path(pen_.context());
    bool begun = false;
    for (const Spot& spot : series.spots) {
      if (!shown(spot)) {
        begun = false;  // a gap
      } else if (begun) {
        cairo_line_to(pen_.context(), across(spot.x), up(spot.y));
      } else {
        cairo_move_to(pen_.context(), across(spot.x), up(spot.y));
        begun = true;
      }
    }
    pen_.stroke(style_of(series.style));
  }

  void draw_markers(const Series& series) {
    const Style& style = style_of(series.style);
    for (const Spot& spot : series.spots) {
      if (!shown(spot)) continue;
      if (spot.bound) pen_.arrow_down(style, across(spot.x), up(spot.y));
      if (series.markers) pen_.marker(style, across(spot.x), up(spot.y), spot.bound);
    }
  }

  void draw_texts(const Series& series) {
    for (const Spot& spot : series.spots) {
      if (!spot.text.empty() && shown(spot)) {
        pen_.text(across(spot.x) + 6, up(spot.y) - 5, spot.text, kText_px - 1.5, Align::Left);
      }
    }
  }

  void frame() {
    pen_.rule(plot_.left, plot_.top, plot_.left, plot_.bottom(), 0.2, 1);
    pen_.rule(plot_.left, plot_.bottom(), plot_.right(), plot_.bottom(), 0.2, 1);
    pen_.text(plot_.left, box_.top + 15, panel_.title, kTitle_px, Align::Left, true);
    pen_.text(plot_.left + plot_.width / 2, box_.bottom() - 10, panel_.x.label, kText_px + 0.5,
              Align::Middle);
    pen_.turned_text(box_.left + 14, plot_.top + plot_.height / 2, panel_.y.label, kText_px + 0.5);
  }

  Pen& pen_;
  const Panel& panel_;
  Box box_;
  Box plot_;
  Scale x_;
  Scale y_;
  bool slanted_ = false;
};

}  // namespace

void draw_panel(Pen& pen, const Panel& panel, const Box& box) { Painter(pen, panel, box).draw(); }

}  // namespace tagmint::plot
