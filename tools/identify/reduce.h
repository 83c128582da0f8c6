#pragma once

#include "tagmint/detect/image.h"

namespace tagmint::identify {

/// The picture half as large: means over 2 x 2 pixels; the last column or row of an odd side is
/// left out. Empty where a side is below 2 px.
detect::Image half_size(detect::ImageView picture);

/// The picture with `margin_px` pixels of one gray level on each side.
detect::Image with_margin(detect::ImageView picture, int margin_px, std::uint8_t gray);

}  // namespace tagmint::identify
