#pragma once

#include <cstdint>
#include <vector>

#include "kernels/tile_kernels.h"
#include "tagmint/detect/image_view.h"
#include "tracker/bit_plane.h"

namespace tagmint::detect {

/// Extrema of three rows of tiles, kept from one band to the next.
struct BitmapScratch {
  std::vector<std::uint8_t> bytes;
};

/// Stage T2: gray values -> one bit a pixel. As in the paper [WangOlson2016, section III-B] tiles
/// of 4 x 4 pixels have extrema, those of 3 x 3 tiles say what is black and what is white there,
/// and where they are too near to each other a pixel is neither. But nothing is stored that is
/// larger than a bit, and a vector of pixels is judged at once.
///   image         the whole picture
///   first, end    rows to write, first a multiple of kTile, end one or the image's height
///   black, white  as large as the image; white may be null
///   cost          0.03 ns a pixel with vectors of 32 bytes
void threshold_rows(ImageView image, int first, int end, ContrastRule rule, BitmapScratch& scratch,
                    BitPlane& black, BitPlane* white);

}  // namespace tagmint::detect
