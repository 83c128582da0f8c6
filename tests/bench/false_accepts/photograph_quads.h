#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "false_accepts/measured_codes.h"

namespace tagmint::bench {

/// What the pictures gave for one code.
struct QuadCounts {
  std::uint64_t quads = 0;  ///< candidates with the layout's kind of border
  std::uint64_t words = 0;  ///< of them, those whose rings passed for a border and were read
  std::vector<std::uint64_t> accepted;  ///< accepted[i] = words taken for a tag with i errors
};

/// All pictures of some folders, seen at full size and halved again and again.
struct PhotographCounts {
  std::uint64_t pictures = 0;  ///< files
  std::uint64_t images = 0;    ///< files in all their sizes
  double megapixels = 0;       ///< of all images
  std::vector<QuadCounts> by_code;
};

/// The image files in `folders` and below, sorted. Of files named by their size (1920x1080.jpg) a
/// folder gives the largest alone: they are one picture.
std::vector<std::string> find_pictures(const std::vector<std::string>& folders);

/// Sends every picture, at full size and halved down to 500 px, through the detector and decodes
/// each candidate quad with each code of its kind of border. Files that cannot be read are told on
/// stderr. The same for any number of threads (0 = all cores).
PhotographCounts decode_photographs(std::span<const std::string> files,
                                    std::span<const MeasuredCode> codes, int threads);

/// A line a code: quads, words, words accepted with 0, 1, 2 and more errors, beside what as many
/// random words would give.
Table photographs_table(const PhotographCounts& counts, std::span<const MeasuredCode> codes);

/// A line for each code and number of errors.
Table photographs_by_errors(const PhotographCounts& counts, std::span<const MeasuredCode> codes);

}  // namespace tagmint::bench
