#include "draw/cairo_owners.h"

#include <fmt/format.h>

#include <new>

#include "tagmint/codec/errors.h"

namespace tagmint::draw {

void check_cairo(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  throw codec::OutputError(fmt::format("the drawing failed: {}", cairo_status_to_string(status)),
                           "", "make the page or the number of tags smaller");
}

}  // namespace tagmint::draw
