// OpenCV's ArUco module reads what we print: the same ids, and the corners where our detector sees
// them.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <memory>
#include <opencv2/aruco.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "support/scratch_folder.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/detect/detector.h"

namespace tagmint {
namespace {

struct PrintedFamily {
  const char* name;
  cv::aruco::PREDEFINED_DICTIONARY_NAME dictionary;
  const char* ids;
  int count;
};

/// The sheet as the program prints it, read by OpenCV.
cv::Mat print_sheet(const PrintedFamily& family) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("sheet.png");
  const test::ProgramResult printed =
      test::tagmint({"sheet", family.name, "--ids", family.ids, "--edge", "25mm", "--paper", "a4",
                     "--dpi", "150", "-o", file});
  EXPECT_EQ(printed.exit_code, 0) << printed.err;
  return cv::imread(file, cv::IMREAD_GRAYSCALE);
}

class OpenCv : public testing::TestWithParam<PrintedFamily> {};

TEST_P(OpenCv, ReadsOurSheetWithTheSameIdsAndCorners) {
  const PrintedFamily& family = GetParam();
  const cv::Mat picture = print_sheet(family);
  ASSERT_FALSE(picture.empty());

  auto decoder = std::make_shared<const codec::Decoder>(codec::find_family(family.name));
  detect::Detector detector({decoder});
  std::map<int, detect::Corners> ours;
  for (const detect::Detection& found : detector.detect(
           {picture.data, picture.cols, picture.rows, static_cast<std::ptrdiff_t>(picture.step)})) {
    ours[static_cast<int>(found.id)] = found.corners;
  }
  EXPECT_EQ(static_cast<int>(ours.size()), family.count);

  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(picture, cv::aruco::getPredefinedDictionary(family.dictionary), corners,
                           ids);
  EXPECT_EQ(static_cast<int>(ids.size()), family.count);
  // OpenCV 4 has these dictionaries turned by 180 degrees and counts clockwise from its top-left
  // corner; its pixel (0, 0) has the centre (0, 0), ours (0.5, 0.5) (docs/conventions.md).
  constexpr std::array<int, 4> kOurCornerOfTheirs = {1, 0, 3, 2};
  for (std::size_t i = 0; i < ids.size(); ++i) {
    ASSERT_TRUE(ours.count(ids[i])) << "only OpenCV sees id " << ids[i];
    for (int k = 0; k < 4; ++k) {
      const detect::Point our_corner = ours[ids[i]][kOurCornerOfTheirs[k]];
      // OpenCV's corners without refinement are whole pixels of a contour inside the black edge.
      EXPECT_NEAR(corners[i][k].x + 0.5, our_corner.x, 1.5) << "id " << ids[i] << " corner " << k;
      EXPECT_NEAR(corners[i][k].y + 0.5, our_corner.y, 1.5) << "id " << ids[i] << " corner " << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Classic, OpenCv,
    testing::Values(PrintedFamily{"tag16h5", cv::aruco::DICT_APRILTAG_16h5, "0-19", 20},
                    PrintedFamily{"tag25h9", cv::aruco::DICT_APRILTAG_25h9, "5-24", 20},
                    PrintedFamily{"tag36h10", cv::aruco::DICT_APRILTAG_36h10, "2300-2319", 20},
                    PrintedFamily{"tag36h11", cv::aruco::DICT_APRILTAG_36h11, "0-19", 20}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace tagmint
