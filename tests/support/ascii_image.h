#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tagmint/detect/image.h"

namespace tagmint::testing {

/// A three-valued picture from rows of characters: '#' black (0), '.' white (255), '?' unknown
/// (127).
inline detect::Image ascii_image(const std::vector<std::string_view>& rows) {
  const int width = rows.empty() ? 0 : static_cast<int>(rows[0].size());
  detect::Image image(width, static_cast<int>(rows.size()));
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < width; ++x) {
      switch (rows.at(y).at(x)) {
        case '#':
          image.at(x, y) = 0;
          break;
        case '.':
          image.at(x, y) = 255;
          break;
        case '?':
          image.at(x, y) = 127;
          break;
        default:
          throw std::invalid_argument("a row of an ASCII picture has a strange character");
      }
    }
  }
  return image;
}

/// The rows of a three-valued picture, as ascii_image() takes them.
inline std::vector<std::string> ascii_rows(detect::ImageView image) {
  std::vector<std::string> rows;
  for (int y = 0; y < image.height; ++y) {
    std::string& row = rows.emplace_back();
    for (int x = 0; x < image.width; ++x) {
      const int value = image.at(x, y);
      row += value == 0 ? '#' : value == 255 ? '.' : value == 127 ? '?' : '!';
    }
  }
  return rows;
}

}  // namespace tagmint::testing
