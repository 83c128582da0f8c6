#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tagmint/detect/image.h"

namespace tagmint::evaluate {

/// The image files in folders and below, sorted; a file that is named is taken itself. Of files
/// named by their size (1920x1080.jpg) a folder gives the largest alone: they are one picture.
/// Links are not followed. Throws codec::InputError for a folder that cannot be read.
std::vector<std::string> find_photographs(const std::vector<std::string>& folders);

/// The mean of each 2 x 2 pixels; a last odd row or column is left out.
detect::Image halved(const detect::Image& image);

/// Reads a picture and shows it at full size and halved again and again, as long as its shorter
/// side is at least 500 px (once at least). Throws codec::InputError as read_gray_image().
void for_each_size(const std::string& path, const std::function<void(const detect::Image&)>& show);

}  // namespace tagmint::evaluate
