#include "cli/identify_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace tagmint::cli {
namespace {

struct Dictionary {
  std::string_view family;
  std::string_view name;
  double turn_deg;  ///< of OpenCV 4's upright tag against ours
};
constexpr std::array kDictionaries = {Dictionary{"tag16h5", "DICT_APRILTAG_16h5", 180},
                                      Dictionary{"tag25h9", "DICT_APRILTAG_25h9", 180},
                                      Dictionary{"tag36h10", "DICT_APRILTAG_36h10", 180},
                                      Dictionary{"tag36h11", "DICT_APRILTAG_36h11", 180},
                                      Dictionary{"aruco-original", "DICT_ARUCO_ORIGINAL", 0}};

}  // namespace

std::optional<OpenCvName> opencv_name(const identify::Candidate& candidate) {
  const auto* known = std::find_if(
      kDictionaries.begin(), kDictionaries.end(),
      [&](const Dictionary& entry) { return entry.family == candidate.family->name(); });
  if (known == kDictionaries.end()) return std::nullopt;
  const double turned = std::fmod(candidate.turned_deg + known->turn_deg, 360);
  return OpenCvName{std::string(known->name), std::round(turned * 10) / 10};
}

std::string border_word(identify::BorderPart border) {
  switch (border) {
    case identify::BorderPart::Whole:
      return "whole";
    case identify::BorderPart::Cut:
      return "cut";
    case identify::BorderPart::None:
      break;
  }
  return "none";
}

}  // namespace tagmint::cli
