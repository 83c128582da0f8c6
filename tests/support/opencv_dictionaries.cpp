#include "support/opencv_dictionaries.h"

#include <opencv2/aruco.hpp>
#include <opencv2/core/version.hpp>

#include "io/family_kinds/data_square.h"

namespace tagmint::test {
namespace {

struct Predefined {
  const char* name;
  int dictionary;
  int declared;
};

// Distances as the comments on cv::aruco::PREDEFINED_DICTIONARY_NAME give them.
constexpr Predefined kPredefined[] = {
    {"DICT_4X4_50", cv::aruco::DICT_4X4_50, 4},
    {"DICT_4X4_100", cv::aruco::DICT_4X4_100, 3},
    {"DICT_4X4_250", cv::aruco::DICT_4X4_250, 3},
    {"DICT_4X4_1000", cv::aruco::DICT_4X4_1000, 2},
    {"DICT_5X5_50", cv::aruco::DICT_5X5_50, 8},
    {"DICT_5X5_100", cv::aruco::DICT_5X5_100, 7},
    {"DICT_5X5_250", cv::aruco::DICT_5X5_250, 6},
    {"DICT_5X5_1000", cv::aruco::DICT_5X5_1000, 5},
    {"DICT_6X6_50", cv::aruco::DICT_6X6_50, 13},
    {"DICT_6X6_100", cv::aruco::DICT_6X6_100, 12},
    {"DICT_6X6_250", cv::aruco::DICT_6X6_250, 11},
    {"DICT_6X6_1000", cv::aruco::DICT_6X6_1000, 9},
    {"DICT_7X7_50", cv::aruco::DICT_7X7_50, 19},
    {"DICT_7X7_100", cv::aruco::DICT_7X7_100, 18},
    {"DICT_7X7_250", cv::aruco::DICT_7X7_250, 17},
    {"DICT_7X7_1000", cv::aruco::DICT_7X7_1000, 14},
    {"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL, 3},
    {"DICT_APRILTAG_16h5", cv::aruco::DICT_APRILTAG_16h5, 5},
    {"DICT_APRILTAG_25h9", cv::aruco::DICT_APRILTAG_25h9, 9},
    {"DICT_APRILTAG_36h10", cv::aruco::DICT_APRILTAG_36h10, 10},
    {"DICT_APRILTAG_36h11", cv::aruco::DICT_APRILTAG_36h11, 11},
#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 8)
    {"DICT_ARUCO_MIP_36h12", cv::aruco::DICT_ARUCO_MIP_36h12, 12},
#endif
};

OpenCvDictionary read(const Predefined& predefined) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(predefined.dictionary);
  const io::DataSquare square(io::square_layout(dictionary->markerSize));
  std::vector<codec::Codeword> codewords;
  for (int id = 0; id < dictionary->bytesList.rows; ++id) {
    const cv::Mat cells = cv::aruco::Dictionary::getBitsFromByteList(dictionary->bytesList.row(id),
                                                                     dictionary->markerSize);
    codec::Codeword rows = 0;
    for (const auto cell : cv::Mat_<unsigned char>(cells)) rows = rows << 1 | (cell != 0 ? 1U : 0U);
    codewords.push_back(square.codeword_of_rows(rows));
  }
  return {predefined.name,
          codec::Family({.name = predefined.name,
                         .layout = io::square_layout(dictionary->markerSize),
                         .min_hamming = 1,
                         .codewords = std::move(codewords),
                         .complexity = {},
                         .origin = {},
                         .levels = {}}),
          predefined.declared, dictionary->maxCorrectionBits};
}

}  // namespace

std::vector<OpenCvDictionary> opencv_dictionaries() {
  std::vector<OpenCvDictionary> all;
  for (const Predefined& predefined : kPredefined) all.push_back(read(predefined));
  return all;
}

}  // namespace tagmint::test
