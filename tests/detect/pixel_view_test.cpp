#include "tagmint/detect/pixel_view.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace tagmint::detect {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// All pixels of a view, row by row.
Bytes pixels_of(ImageView view) {
  Bytes pixels;
  for (int y = 0; y < view.height; ++y) {
    pixels.insert(pixels.end(), view.row(y), view.row(y) + view.width);
  }
  return pixels;
}

TEST(PixelView, GrayIsTakenAsItIs) {
  const Bytes bytes = {1, 2, 3, 0, 4, 5, 6, 0};
  Image scratch;
  const ImageView view =
      gray_view({.data = bytes.data(), .width = 3, .height = 2, .stride = 4}, scratch);
  EXPECT_EQ(view.data, bytes.data());
  EXPECT_EQ(pixels_of(view), (Bytes{1, 2, 3, 4, 5, 6}));
}

TEST(PixelView, ColoursBecomeLumaInAnyOrder) {
  const Bytes rgb = {255, 0, 0, 0, 255, 0, 0, 0, 255, 90, 90, 90};
  Image scratch;
  const PixelView view{.data = rgb.data(),
                       .width = 4,
                       .height = 1,
                       .stride = 12,
                       .step = 3,
                       .red = 0,
                       .green = 1,
                       .blue = 2};
  EXPECT_EQ(pixels_of(gray_view(view, scratch)), (Bytes{76, 150, 29, 90}));
  PixelView bgr = view;
  bgr.red = 2;
  bgr.blue = 0;
  EXPECT_EQ(pixels_of(gray_view(bgr, scratch)), (Bytes{29, 150, 76, 90}));
}

TEST(PixelView, LumaBetweenOtherSamplesAndRowsFromBelow) {
  const Bytes yuyv = {1, 200, 2, 200, 3, 200, 4, 200};
  Image scratch;
  const PixelView view{.data = yuyv.data() + 4, .width = 2, .height = 2, .stride = -4, .step = 2};
  EXPECT_EQ(pixels_of(gray_view(view, scratch)), (Bytes{3, 4, 1, 2}));
}

TEST(PixelView, NothingIsNothingAndPixelsNeedData) {
  Image scratch;
  EXPECT_TRUE(gray_view({}, scratch).empty());
  EXPECT_THROW(gray_view({.width = 2, .height = 2}, scratch), std::invalid_argument);
}

}  // namespace
}  // namespace tagmint::detect
