// Boards as Poppler draws the PDF and a camera sees it from the side: our detector and libapriltag
// find all tags.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "board/board_writer.h"
#include "draw/units.h"
#include "support/board_on_page.h"
#include "support/board_samples.h"
#include "support/camera_view.h"
#include "support/libapriltag_reader.h"
#include "support/rasterise.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/detect/detector.h"

namespace tagmint::board {
namespace {

constexpr double kDpi = 150;
constexpr double kPixelsAMm = kDpi / draw::kMmAnInch;
// Half a pixel: the edges in the picture of the page are rounded to a few hundredths of a mm, which
// is a tenth of a pixel of the camera, and libapriltag's corners are some tenths off.
constexpr double kCornerPx = 0.5;

/// Tags of one family as they are printed.
struct PrintedFamily {
  codec::SharedFamily family;
  std::map<codec::TagId, detect::Corners> corners_px;  // in the camera's image
};

/// What a camera sees of a page, and where the board's tags are in it.
struct Seen {
  detect::Image image;
  std::map<std::string, PrintedFamily> families;
};

codec::SharedFamily as_printed(const BoardTag& tag) {
  return std::make_shared<const codec::Family>(
      codec::FamilyParts{.name = tag.family->name(),
                         .layout = tag.layout,
                         .min_hamming = tag.family->min_hamming(),
                         .codewords = codec::first_codewords(*tag.family, tag.family->size()),
                         .complexity = tag.family->complexity(),
                         .origin = {},
                         .levels = {}});
}

void erase(detect::Image& picture, const draw::Box& box) {
  for (int y = static_cast<int>(box.y_mm * kPixelsAMm); y < box.bottom_mm() * kPixelsAMm; ++y) {
    for (int x = static_cast<int>(box.x_mm * kPixelsAMm); x < box.right_mm() * kPixelsAMm; ++x) {
      picture.at(std::min(x, picture.width() - 1), std::min(y, picture.height() - 1)) = 255;
    }
  }
}

/// Prints the board, takes its black squares away and looks at it.
Seen look_at(const Board& board) {
  const BoardPage page = page_of_own_size(board, 12, {});
  detect::Image picture =
      test::pdf_pages(board_file(board, page, draw::FileKind::Pdf, {}), kDpi).at(0);
  for (const draw::Box& square : board.squares) {
    const detect::Point corner = test::on_page(board, page, {square.x_mm, square.y_mm});
    erase(picture, {corner.x, corner.y, square.width_mm, square.height_mm});
  }
  const test::CameraView view;
  const detect::Homography map = test::picture_to_image(picture, view);
  Seen seen{test::seen_by_camera(picture, view), {}};
  for (const BoardTag& tag : board.tags) {
    PrintedFamily& printed = seen.families[tag.family->name()];
    if (!printed.family) printed.family = as_printed(tag);
    detect::Corners corners = test::corners_on_page(board, page, border_corners(tag));
    for (detect::Point& p : corners) p = map.project(kPixelsAMm * p);
    printed.corners_px[tag.id] = corners;
  }
  return seen;
}

/// Expects each tag of the family once and at its place, and no other.
template <typename Tags>
void expect_all(const PrintedFamily& printed, const Tags& found, const std::string& who) {
  SCOPED_TRACE(who + ", " + printed.family->name());
  auto missing = printed.corners_px;
  for (const auto& tag : found) {
    const auto truth = missing.find(tag.id);
    ASSERT_NE(truth, missing.end()) << "id " << tag.id << " is not there, or found twice";
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LT(length(tag.corners[k] - truth->second[k]), kCornerPx) << "id " << tag.id;
    }
    missing.erase(truth);
  }
  EXPECT_EQ(missing.size(), 0u) << "the first that is not found: " << missing.begin()->first;
}

void expect_all_found(const Board& board) {
  const Seen seen = look_at(board);
  for (const auto& [name, printed] : seen.families) {
    detect::Detector detector({std::make_shared<const codec::Decoder>(
        printed.family, codec::DecoderOptions{.max_errors = 1,
                                              .allow_unsafe_radius = false,
                                              .engine = codec::DecoderEngine::Auto,
                                              .ids = {}})});
    expect_all(printed, detector.detect(seen.image), "tagmint");
    expect_all(printed, test::LibapriltagReader(*printed.family).read(seen.image), "libapriltag");
  }
}

TEST(BoardDetection, EveryTagOfAPlainGridIsFound) {
  expect_all_found(
      test::sample_grid("tag36h11", {.columns = 6, .rows = 5, .edge_mm = 24, .gap_mm = 7.2}, 100));
  expect_all_found(test::sample_grid("tagStandard41h12",
                                     {.columns = 4, .rows = 3, .edge_mm = 20, .gap_mm = 20}));
}

TEST(BoardDetection, TheLeastGapIsWideEnough) {
  expect_all_found(
      test::sample_grid("tag36h11", {.columns = 3, .rows = 2, .edge_mm = 40, .gap_mm = 5}));
}

TEST(BoardDetection, EveryTagOfABundleIsFound) { expect_all_found(test::sample_bundle()); }

TEST(BoardDetection, TagsInHolesAndTheirHostsAreFoundInOnePicture) {
  expect_all_found(test::mixed_bundle());
}

// Kalibr's black squares join the borders of neighbours, and detectors that follow connected areas,
// as both of these do, lose most of its tags; so the squares are taken away first. That they stand
// where they belong is measured in PrintedBoard.
TEST(BoardDetection, TagsWithKalibrsBorderAreFoundBetweenItsSquares) {
  expect_all_found(test::kalibr_board());
}

}  // namespace
}  // namespace tagmint::board
