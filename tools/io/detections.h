#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tagmint/detect/detection.h"
#include "tagmint/detect/pose.h"

namespace tagmint::io {

/// One tag found and, where the camera and the tag's size are known, its pose.
struct FoundTag {
  detect::Detection detection;
  std::optional<detect::PoseEstimate> pose;
};

/// What was found in one image, or why it could not be read.
struct ImageResult {
  std::string image;                 ///< as it was named on the command line
  int width = 0;                     ///< px
  int height = 0;                    ///< px
  double elapsed_ms = 0;             ///< the detection alone
  std::vector<FoundTag> tags;        ///< sorted by family, id, centre
  std::optional<std::string> error;  ///< instead of all but `image`
};

/// One line of JSON with its newline, in the shape that docs/detect.md gives. Numbers have
/// 12 significant digits: corners come back to a millionth of a pixel.
std::string format_jsonl(const ImageResult& result);

/// The header line of the CSV form.
///   poses   whether the columns of poses are wanted
std::string csv_header(bool poses);
/// One line of CSV a tag (RFC 4180, but with plain newlines); none for an image without tags.
std::string format_csv(const ImageResult& result, bool poses);

/// Some lines for people: the image, then a table of its tags with aligned columns.
std::string format_text(const ImageResult& result);

}  // namespace tagmint::io
