#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "tagmint/detect/image.h"

namespace tagmint::io {

/// One reader a kind; arguments, result and errors as decode_gray_image().
detect::Image decode_pnm(std::string_view bytes, const std::string& source);
detect::Image decode_png(std::string_view bytes, const std::string& source);
detect::Image decode_jpeg(std::string_view bytes, const std::string& source);
detect::Image decode_tiff(std::string_view bytes, const std::string& source);

/// Throws InputError unless the sides are at least 1 and the pixels at most kMaxPixels. To be
/// called before any memory is taken for the pixels.
void check_image_size(std::int64_t width, std::int64_t height, const std::string& source);

/// Throws the InputError of a malformed or cut image: "the PNG image is damaged: REASON (SOURCE)".
[[noreturn]] void throw_damaged(std::string_view kind, std::string_view reason,
                                const std::string& source);

}  // namespace tagmint::io
