#pragma once

#include "tagmint/detect/image.h"

namespace tagmint::evaluate {

/// The picture as a baseline JPEG file of that quality (1..100, libjpeg's scale) keeps it.
detect::Image through_jpeg(const detect::Image& image, int quality);

}  // namespace tagmint::evaluate
