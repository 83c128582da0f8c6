// OpenCV's ArUco module, told of a border of two cells, reads the tags of Kalibr's boards.
#include <gtest/gtest.h>

#include <map>
#include <opencv2/aruco.hpp>
#include <vector>

#include "board/board_writer.h"
#include "draw/units.h"
#include "support/board_on_page.h"
#include "support/board_samples.h"
#include "support/rasterise.h"

namespace tagmint::board {
namespace {

TEST(OpenCvReadsBoard, TagsWithABorderOfTwoCellsBetweenKalibrsSquares) {
  constexpr double kDpi = 150;
  constexpr double kPixelsAMm = kDpi / draw::kMmAnInch;
  const Board board = test::kalibr_board();
  const BoardPage page = page_of_own_size(board, 12, {});
  detect::Image picture =
      test::pdf_pages(board_file(board, page, draw::FileKind::Pdf, {}), kDpi).at(0);
  cv::Mat gray(picture.height(), picture.width(), CV_8UC1, picture.row(0));
  // The squares join the contours of neighbours; they are taken away first.
  for (const draw::Box& square : board.squares) {
    const detect::Point corner =
        kPixelsAMm * test::on_page(board, page, {square.x_mm, square.y_mm});
    const cv::Rect area(static_cast<int>(corner.x), static_cast<int>(corner.y),
                        static_cast<int>(square.width_mm * kPixelsAMm) + 2,
                        static_cast<int>(square.height_mm * kPixelsAMm) + 2);
    gray(area & cv::Rect(0, 0, gray.cols, gray.rows)).setTo(255);
  }
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->markerBorderBits = 2;
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(gray, cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11),
                           corners, ids, parameters);
  std::map<int, detect::Point> middles;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    detect::Point sum;
    for (const cv::Point2f& corner : corners[i]) sum = sum + detect::Point{corner.x, corner.y};
    middles[ids[i]] = 0.25 * sum;
  }
  ASSERT_EQ(middles.size(), board.tags.size());
  for (const BoardTag& tag : board.tags) {
    ASSERT_TRUE(middles.contains(static_cast<int>(tag.id))) << tag.id;
    const detect::Point planned = kPixelsAMm * test::on_page(board, page, tag.centre_mm);
    // OpenCV's corners without refinement are whole pixels of a contour inside the black edge.
    EXPECT_LT(length(middles[static_cast<int>(tag.id)] - planned), 1.5) << tag.id;
  }
}

}  // namespace
}  // namespace tagmint::board
