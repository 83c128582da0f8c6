#pragma once

#include <cairo.h>

#include <filesystem>
#include <functional>
#include <memory>

#include "draw/read_back.h"

namespace tagmint::draw {

/// What this build was made with.
#ifdef TAGMINT_HAVE_POPPLER
inline constexpr bool kReadsPdf = true;
#else
inline constexpr bool kReadsPdf = false;
#endif
#ifdef TAGMINT_HAVE_RSVG
inline constexpr bool kReadsSvg = true;
#else
inline constexpr bool kReadsSvg = false;
#endif

std::unique_ptr<WrittenFile> open_written_pdf(const std::filesystem::path& path);
std::unique_ptr<WrittenFile> open_written_svg(const std::filesystem::path& path);

/// A white page of that many pixels with what `draw` draws on it, as gray.
detect::Image drawn_page(double width_px, double height_px,
                         const std::function<void(cairo_t*)>& draw);

/// Throws the OutputError for a file that cannot be drawn.
[[noreturn]] void fail_to_read_back(const std::filesystem::path& path, const char* reason);

}  // namespace tagmint::draw
