// Boards measured in what Poppler and librsvg draw, and compared with what their config files say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "board/board_notes.h"
#include "board/board_writer.h"
#include "board/clearance.h"
#include "board/configs/board_config.h"
#include "draw/units.h"
#include "support/board_on_page.h"
#include "support/board_samples.h"
#include "support/measured_corners.h"
#include "support/rasterise.h"
#include "support/scratch_folder.h"

namespace tagmint::board {
namespace {

using nlohmann::json;
using test::corners_on_page;
using test::on_page;

constexpr double kMostErrorMm = 0.05;
using CornersOfIds = std::map<codec::TagId, detect::Corners>;

/// A board as it is printed: one page, drawn by Poppler.
struct Printed {
  Board board;
  BoardPage page;
  double dpi;
  detect::Image picture;

  Printed(Board planned, double resolution)
      : board(std::move(planned)),
        page(page_of_own_size(board, 12, {})),
        dpi(resolution),
        picture(test::pdf_pages(board_file(board, page, draw::FileKind::Pdf, {}), dpi).at(0)) {}

  double px_a_mm() const { return dpi / draw::kMmAnInch; }
  /// Gray at a place on the board.
  int gray(detect::Point p) const {
    const detect::Point at = px_a_mm() * on_page(board, page, p);
    return picture.at(static_cast<int>(at.x), static_cast<int>(at.y));
  }
};

/// The corners of all tags as they are drawn, in mm on the page.
CornersOfIds measured(const Printed& printed) {
  CornersOfIds corners;
  for (const BoardTag& tag : printed.board.tags) {
    corners[tag.id] = test::measured_corners(
        printed.picture, printed.px_a_mm(),
        corners_on_page(printed.board, printed.page, border_corners(tag)),
        tag.edge_mm / tag.layout.width_at_border(), tag.layout.reversed_border());
  }
  return corners;
}

/// Expects that the corners which a config gives, in mm on the page, are those that were drawn.
void expect_drawn(const Printed& printed, const CornersOfIds& told) {
  const CornersOfIds drawn = measured(printed);
  ASSERT_EQ(told.size(), drawn.size());
  for (const auto& [id, corners] : told) {
    ASSERT_TRUE(drawn.contains(id)) << id;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LT(length(corners[k] - drawn.at(id)[k]), kMostErrorMm) << id << " corner " << k;
    }
  }
}

constexpr Grid kPlain = {.columns = 3, .rows = 2, .edge_mm = 40, .gap_mm = 10};

/// Our own kind: x right, y down, from the board's origin.
CornersOfIds told_by_tagmint(const Printed& printed, const json& file) {
  CornersOfIds told;
  for (const json& tag : file.at("tags")) {
    detect::Corners& corners = told[tag.at("id").get<codec::TagId>()];
    for (std::size_t k = 0; k < 4; ++k) {
      const json& p = tag.at("corners").at(k);
      corners[k] = on_page(printed.board, printed.page,
                           {1000 * p.at(0).get<double>(), 1000 * p.at(1).get<double>()});
    }
  }
  return told;
}

TEST(PrintedBoard, TagmintConfigTellsTheCornersThatAreDrawn) {
  for (const Board& board :
       {test::kalibr_board(), test::sample_bundle(), test::mixed_bundle(),
        test::sample_grid("tagStandard41h12",
                          {.columns = 2, .rows = 2, .edge_mm = 33.3, .gap_mm = 33.3})}) {
    const Printed printed(board, 300);
    expect_drawn(printed,
                 told_by_tagmint(printed, json::parse(board_config(ConfigKind::Tagmint, board))));
  }
}

TEST(PrintedBoard, TagmintConfigTellsTheCornersThatAreDrawnAt1200Dpi) {
  const Board board =
      test::sample_grid("tag36h11", {.columns = 2, .rows = 1, .edge_mm = 24, .gap_mm = 7.2});
  const Printed printed(board, 1200);
  expect_drawn(printed,
               told_by_tagmint(printed, json::parse(board_config(ConfigKind::Tagmint, board))));
}

/// A vector of three.
using Vector = std::array<double, 3>;

/// Rotates by a unit quaternion: v + 2 w (u x v) + 2 u x (u x v).
Vector rotated(double w, const Vector& u, const Vector& v) {
  const auto times = [](const Vector& a, const Vector& b) -> Vector {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const Vector first = times(u, v);
  const Vector second = times(u, first);
  return {v[0] + 2 * (w * first[0] + second[0]), v[1] + 2 * (w * first[1] + second[1]),
          v[2] + 2 * (w * first[2] + second[2])};
}

TEST(PrintedBoard, WpilibConfigTellsTheCornersThatAreDrawn) {
  Board bundle = test::sample_bundle();
  for (BoardTag& tag : bundle.tags) tag.edge_mm = 24;
  bundle.extent = extent_of(bundle.tags);
  for (const Board& board : {test::sample_grid("tag36h11", kPlain, 1), bundle}) {
    const Printed printed(board, 300);
    const json file = json::parse(board_config(ConfigKind::Wpilib, board));
    CornersOfIds told;
    for (const json& tag : file.at("tags")) {
      const json& place = tag.at("pose").at("translation");
      const json& turn = tag.at("pose").at("rotation").at("quaternion");
      EXPECT_EQ(place.at("x").get<double>(), 0);
      for (std::size_t k = 0; k < 4; ++k) {
        // The tag's own axes: x out of it towards the viewer, y right as seen, z up.
        const double half = board.tags[0].edge_mm / 2000;
        const Vector corner =
            rotated(turn.at("W"), {turn.at("X"), turn.at("Y"), turn.at("Z")},
                    {0, half * detect::kTagCorners[k].x, -half * detect::kTagCorners[k].y});
        // The field's y and z from the board's bottom left corner.
        told[tag.at("ID").get<codec::TagId>()][k] = {
            printed.page.board.x_mm + 1000 * (place.at("y").get<double>() + corner[1]),
            printed.page.board.bottom_mm() - 1000 * (place.at("z").get<double>() + corner[2])};
      }
    }
    expect_drawn(printed, told);
  }
}

#ifdef TAGMINT_PYTHON_YAML
/// YAML as PyYAML reads it, which is what ROS 1 and Kalibr use.
json parsed_yaml(const std::string& yaml) {
  const test::ScratchFolder folder;
  return json::parse(test::output_of(fmt::format(
      "'{}' -c 'import json, sys, yaml; json.dump(yaml.safe_load(open(sys.argv[1])), sys.stdout)' "
      "'{}'",
      TAGMINT_PYTHON_YAML, folder.write("config.yaml", yaml))));
}

TEST(PrintedBoard, KalibrConfigTellsTheCornersThatAreDrawn) {
  const Board board = test::kalibr_board();
  const Printed printed(board, 300);
  const json file = parsed_yaml(board_config(ConfigKind::Kalibr, board));
  EXPECT_EQ(file.at("target_type"), "aprilgrid");
  EXPECT_EQ(file.at("tagCols"), 3);
  EXPECT_EQ(file.at("tagRows"), 2);
  const double size = 1000 * file.at("tagSize").get<double>();
  const double spacing = file.at("tagSpacing").get<double>();
  EXPECT_NEAR(size, 40, 1e-6);
  EXPECT_NEAR(spacing, 0.3, 1e-9);
  // As Kalibr counts: ids from the bottom left row by row, x right, y up, the origin at the bottom
  // left corner of tag 0. On the page that corner is a gap right of and above the board's.
  const detect::Point origin = {printed.page.board.x_mm + spacing * size,
                                printed.page.board.bottom_mm() - spacing * size};
  CornersOfIds told;
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double x = column * size * (1 + spacing);
      const double y = row * size * (1 + spacing);
      told[static_cast<codec::TagId>(3 * row + column)] = {
          {{origin.x + x, origin.y - y},
           {origin.x + x + size, origin.y - y},
           {origin.x + x + size, origin.y - y - size},
           {origin.x + x, origin.y - y - size}}};
    }
  }
  expect_drawn(printed, told);
}

TEST(PrintedBoard, Ros1ConfigTellsTheCornersThatAreDrawn) {
  for (const Board& board : {test::sample_grid("tag36h11", kPlain, 40), test::sample_bundle()}) {
    const Printed printed(board, 300);
    const json file = parsed_yaml(board_config(ConfigKind::Ros1, board));
    ASSERT_EQ(file.at("tag_bundles").size(), 1u);
    CornersOfIds told;
    for (const json& tag : file.at("tag_bundles").at(0).at("layout")) {
      for (std::size_t k = 0; k < 4; ++k) {
        // The tag's own axes: x right, y up, z towards the viewer; the bundle's as well.
        const double half = tag.at("size").get<double>() / 2;
        const Vector corner =
            rotated(tag.at("qw"), {tag.at("qx"), tag.at("qy"), tag.at("qz")},
                    {half * detect::kTagCorners[k].x, -half * detect::kTagCorners[k].y, 0});
        told[tag.at("id").get<codec::TagId>()][k] =
            on_page(board, printed.page,
                    {1000 * (tag.at("x").get<double>() + corner[0]),
                     -1000 * (tag.at("y").get<double>() + corner[1])});
      }
    }
    expect_drawn(printed, told);
    ASSERT_EQ(file.at("standalone_tags").size(), board.tags.size());
    for (std::size_t i = 0; i < board.tags.size(); ++i) {
      const json& tag = file.at("standalone_tags").at(i);
      EXPECT_EQ(tag.at("id"), board.tags[i].id);
      EXPECT_NEAR(tag.at("size").get<double>(), board.tags[i].edge_mm / 1000, 1e-12);
      EXPECT_EQ(tag.at("name"), fmt::format("tag_{}", board.tags[i].id));
    }
  }
}

TEST(PrintedBoard, Ros2ConfigTellsTheSizesThatAreDrawn) {
  const Board board = test::sample_bundle();
  const Printed printed(board, 300);
  const json parameters =
      parsed_yaml(board_config(ConfigKind::Ros2, board)).at("/**").at("ros__parameters");
  EXPECT_EQ(parameters.at("family"), "36h11");
  EXPECT_EQ(parameters.at("max_hamming"), 2);
  EXPECT_TRUE(parameters.at("size").is_number_float());
  const json& tags = parameters.at("tag");
  const CornersOfIds drawn = measured(printed);
  ASSERT_EQ(tags.at("ids").size(), drawn.size());
  ASSERT_EQ(tags.at("frames").size(), drawn.size());
  ASSERT_EQ(tags.at("sizes").size(), drawn.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const auto id = tags.at("ids").at(i).get<codec::TagId>();
    EXPECT_EQ(tags.at("frames").at(i), fmt::format("tag36h11:{}", id));
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(length(drawn.at(id)[k] - drawn.at(id)[(k + 1) % 4]),
                  1000 * tags.at("sizes").at(i).get<double>(), kMostErrorMm);
    }
  }
}
#endif

TEST(PrintedBoard, KalibrSquaresTouchTheCornersOfAllTags) {
  const Printed printed(test::kalibr_board(), 300);
  for (const BoardTag& tag : printed.board.tags) {
    for (const detect::Point corner : border_corners(tag)) {
      const detect::Point outwards = {corner.x > tag.centre_mm.x ? 0.2 : -0.2,
                                      corner.y > tag.centre_mm.y ? 0.2 : -0.2};
      EXPECT_EQ(printed.gray(corner - outwards), 0);  // the border
      EXPECT_EQ(printed.gray(corner + outwards), 0);  // the square
      EXPECT_EQ(printed.gray({corner.x + outwards.x, corner.y - outwards.y}), 255);
      EXPECT_EQ(printed.gray({corner.x - outwards.x, corner.y + outwards.y}), 255);
    }
  }
  // Each square is black up to its rim and white beyond it, but for where tags touch its corners.
  for (const draw::Box& square : printed.board.squares) {
    const detect::Point middle = {square.x_mm + square.width_mm / 2,
                                  square.y_mm + square.height_mm / 2};
    const double half = square.width_mm / 2;
    for (const detect::Point side : {detect::Point{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      EXPECT_EQ(printed.gray(middle + (half - 0.2) * side), 0);
      EXPECT_EQ(printed.gray(middle + (half + 0.2) * side), 255);
    }
  }
}

/// Pixels darker than paper that lie in no tag's square of ink, two pixels of its rim aside.
int ink_beside_tags(const Printed& printed) {
  std::vector<draw::Box> tags;
  for (const BoardTag& tag : printed.board.tags) {
    const double side = ink_side_mm(tag) + 4 / printed.px_a_mm();
    const detect::Point corner =
        on_page(printed.board, printed.page, tag.centre_mm - detect::Point{side / 2, side / 2});
    tags.push_back({corner.x, corner.y, side, side});
  }
  int count = 0;
  for (int y = 0; y < printed.picture.height(); ++y) {
    for (int x = 0; x < printed.picture.width(); ++x) {
      const double x_mm = (x + 0.5) / printed.px_a_mm();
      const double y_mm = (y + 0.5) / printed.px_a_mm();
      const bool in_tag = std::any_of(tags.begin(), tags.end(), [&](const draw::Box& box) {
        return x_mm > box.x_mm && x_mm < box.right_mm() && y_mm > box.y_mm &&
               y_mm < box.bottom_mm();
      });
      if (!in_tag && printed.picture.at(x, y) != 255) ++count;
    }
  }
  return count;
}

TEST(PrintedBoard, NothingIsDrawnBetweenPlainTags) {
  EXPECT_EQ(ink_beside_tags(Printed(test::sample_grid("tag36h11", kPlain), 200)), 0);
  const Grid narrow = {.columns = 2, .rows = 2, .edge_mm = 20, .gap_mm = 20};
  EXPECT_EQ(ink_beside_tags(Printed(test::sample_grid("tagStandard41h12", narrow), 200)), 0);
}

TEST(PrintedBoard, BlackHasNoSeamsAtOddZooms) {
  for (const double dpi : {53.0, 97.0, 131.0}) {
    const Printed printed(test::kalibr_board(), dpi);
    const double pixel = 1 / printed.px_a_mm();
    for (const BoardTag& tag : printed.board.tags) {
      // All along the middle of the two cells of the border.
      const double ring = tag.edge_mm / 2 - tag.edge_mm / tag.layout.width_at_border();
      for (double t = -ring; t <= ring; t += pixel) {
        for (const detect::Point p : {detect::Point{t, ring}, {t, -ring}, {ring, t}, {-ring, t}}) {
          EXPECT_EQ(printed.gray(tag.centre_mm + p), 0) << dpi;
        }
      }
    }
  }
}

TEST(PrintedBoard, NotesTellSizesIdsAndScale) {
  const Board board = test::kalibr_board();
  const BoardPage page = page_on_paper(board, 210, 297, 10, board_notes(board));
  const test::ScratchFolder folder;
  const std::string path = folder.write("a.pdf", board_file(board, page, draw::FileKind::Pdf, {}));
  const std::string text = test::output_of("pdftotext -layout '" + path + "' -");
  for (const char* part : {"tag36h11: edge 40 mm, outer 48 mm, ids 0-5",
                           "3 x 2 tags, ids from the bottom left, spacing 0.3 (gap 12 mm), border "
                           "of 2 cells",
                           "print at 100 %, not fitted to the page", "measure me"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

TEST(PrintedBoard, SvgHasThePagesSizeAndTheTagsPlaces) {
  const Board board = test::mixed_bundle();
  const BoardPage page = page_of_own_size(board, 5, {});
  const detect::Image picture =
      test::svg_picture(board_file(board, page, draw::FileKind::Svg, {}), 254);
  EXPECT_NEAR(picture.width(), 10 * page.width_mm, 1);
  EXPECT_NEAR(picture.height(), 10 * page.height_mm, 1);
  for (const BoardTag& tag : board.tags) {
    const detect::Corners planned = corners_on_page(board, page, border_corners(tag));
    const detect::Corners drawn =
        test::measured_corners(picture, 10, planned, tag.edge_mm / tag.layout.width_at_border(),
                               tag.layout.reversed_border());
    for (std::size_t k = 0; k < 4; ++k) EXPECT_LT(length(planned[k] - drawn[k]), kMostErrorMm);
  }
}

}  // namespace
}  // namespace tagmint::board
