#include "refine/photometric_pixels.h"

#include <cassert>

namespace tagmint::detect {

void PhotometricPixels::reset(std::size_t most) {
  const std::size_t room = (most + 2 * kPixelBlock - 1) / kPixelBlock * kPixelBlock + kPixelBlock;
  size_ = 0;
  if (x.size() >= room) return;
  for (std::vector<float>* values :
       {&x, &y, &gray, &line_x, &line_y, &across_x, &across_y, &cosine, &weight}) {
    values->resize(room);
  }
  for (std::vector<std::uint32_t>& words : pattern) words.resize(room);
  columns.resize(room);
}

void PhotometricPixels::add(const PhotometricPixel& pixel, const CellSurroundings& around) {
  assert(size_ < capacity());
  x[size_] = static_cast<float>(pixel.x);
  y[size_] = static_cast<float>(pixel.y);
  gray[size_] = static_cast<float>(pixel.gray);
  line_x[size_] = static_cast<float>(pixel.line_x);
  line_y[size_] = static_cast<float>(pixel.line_y);
  across_x[size_] = static_cast<float>(pixel.across_x);
  across_y[size_] = static_cast<float>(pixel.across_y);
  cosine[size_] = static_cast<float>(pixel.cosine);
  weight[size_] = static_cast<float>(pixel.weight);
  for (int word = 0; word < kMaxPatternWords; ++word) pattern[word][size_] = around.words[word];
  ++size_;
}

void PhotometricPixels::pad() {
  for (std::size_t i = size_; i < blocks() * kPixelBlock; ++i) {
    for (std::vector<float>* values : {&x, &y, &gray, &line_x, &line_y, &cosine, &weight}) {
      (*values)[i] = 0;
    }
    across_x[i] = across_y[i] = 1;
    for (std::vector<std::uint32_t>& words : pattern) words[i] = 0;
  }
}

PhotometricPixel PhotometricPixels::pixel(std::size_t i) const {
  return {x[i],
          y[i],
          gray[i],
          static_cast<int>(line_x[i]),
          static_cast<int>(line_y[i]),
          across_x[i],
          across_y[i],
          cosine[i],
          weight[i]};
}

}  // namespace tagmint::detect
