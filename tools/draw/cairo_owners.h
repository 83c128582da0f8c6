#pragma once

#include <cairo.h>

#include <memory>

namespace tagmint::draw {

struct DestroySurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyContext {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using SurfaceOwner = std::unique_ptr<cairo_surface_t, DestroySurface>;
using ContextOwner = std::unique_ptr<cairo_t, DestroyContext>;

/// Throws std::bad_alloc or codec::OutputError when Cairo failed.
void check_cairo(cairo_status_t status);

}  // namespace tagmint::draw
