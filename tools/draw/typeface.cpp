#include "draw/typeface.h"

#include <cairo.h>

#include "draw/cairo_owners.h"
#include "draw/utf8.h"

namespace tagmint::draw {
namespace {

/// Size at which glyphs are loaded. Cairo keeps path coordinates in steps of 1/256: these are then
/// 1/256,000 of the font's size.
constexpr double kLoadSize = 1000.0;

Path copy_path(cairo_t* context) {
  const std::unique_ptr<cairo_path_t, decltype(&cairo_path_destroy)> copy(cairo_copy_path(context),
                                                                          &cairo_path_destroy);
  check_cairo(copy->status);
  const auto unit = [](const cairo_path_data_t& data) {
    return PathPoint{data.point.x / kLoadSize, data.point.y / kLoadSize};
  };
  Path path;
  for (int i = 0; i < copy->num_data; i += copy->data[i].header.length) {
    const cairo_path_data_t* const data = &copy->data[i];
    // Cairo ends each closed contour with a point of its own, where the next one may start.
    const bool last = i + data->header.length >= copy->num_data;
    const bool followed_by_move =
        !last && copy->data[i + data->header.length].header.type == CAIRO_PATH_MOVE_TO;
    switch (data->header.type) {
      case CAIRO_PATH_MOVE_TO:
        if (!last && !followed_by_move) path.move_to(unit(data[1]).x, unit(data[1]).y);
        break;
      case CAIRO_PATH_LINE_TO:
        path.line_to(unit(data[1]).x, unit(data[1]).y);
        break;
      case CAIRO_PATH_CURVE_TO:
        path.curve_to(unit(data[1]).x, unit(data[1]).y, unit(data[2]).x, unit(data[2]).y,
                      unit(data[3]).x, unit(data[3]).y);
        break;
      case CAIRO_PATH_CLOSE_PATH:
        path.close();
        break;
    }
  }
  return path;
}

}  // namespace

struct Typeface::Font {
  SurfaceOwner surface;
  ContextOwner context;
};

Typeface::Typeface() : font_(std::make_unique<Font>()) {
  font_->surface.reset(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  check_cairo(cairo_surface_status(font_->surface.get()));
  font_->context.reset(cairo_create(font_->surface.get()));
  cairo_t* const context = font_->context.get();
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, kLoadSize);
  const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> options(
      cairo_font_options_create(), &cairo_font_options_destroy);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context, options.get());
  check_cairo(cairo_status(context));
}

Typeface::~Typeface() = default;

std::vector<const Glyph*> Typeface::glyphs(const std::string& text) {
  std::vector<const Glyph*> line;
  for (const char32_t character : characters_of(text)) {
    auto place = glyphs_.find(character);
    if (place == glyphs_.end()) place = glyphs_.emplace(character, load(character)).first;
    line.push_back(&place->second);
  }
  return line;
}

Glyph Typeface::load(char32_t character) const {
  const std::string utf8 = utf8_of(character);
  cairo_t* const context = font_->context.get();
  cairo_text_extents_t extents = {};
  cairo_text_extents(context, utf8.c_str(), &extents);
  cairo_new_path(context);
  cairo_move_to(context, 0, 0);
  cairo_text_path(context, utf8.c_str());
  Glyph glyph{character, copy_path(context), extents.x_advance / kLoadSize};
  cairo_new_path(context);
  check_cairo(cairo_status(context));
  return glyph;
}

double width_of(const std::vector<const Glyph*>& glyphs) {
  double width = 0.0;
  for (const Glyph* glyph : glyphs) width += glyph->advance;
  return width;
}

}  // namespace tagmint::draw
