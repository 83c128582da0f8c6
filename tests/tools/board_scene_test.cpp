// Boards in scene files: what they say, and what is seen of them.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "board/grid_board.h"
#include "scene/scene_file.h"
#include "support/scene_accuracy.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/errors.h"
#include "tagmint/detect/detector.h"

namespace tagmint::scene {
namespace {

using detect::Point;

Scene parse(const std::string& boards, const std::string& rest = "") {
  return parse_scene(R"({"width":640,"height":480,"background":{"gray":100},"boards":[)" + boards +
                         "]" + rest + "}",
                     "test.json", ".");
}

void expect_fault(const std::string& board, const std::string& part) {
  try {
    parse(board);
    ADD_FAILURE() << "read: " << board;
  } catch (const codec::InputError& fault) {
    EXPECT_NE(std::string(fault.what()).find(part), std::string::npos) << fault.what();
  }
}

/// Where the camera of the scene sees a place of a frontal board at depth `z`, all in metres.
Point seen(Point on_board, Point middle, double z) {
  return {640 * (on_board.x + middle.x) / z + 320, 640 * (on_board.y + middle.y) / z + 240};
}

TEST(BoardScene, HasTheTagsWhereTheBoardHasThem) {
  for (const std::string style : {"plain", "kalibr"}) {
    const Scene scene = parse(R"({"family":"tag36h11","grid":[4,3],"edge_m":0.04,"spacing":0.35,
        "first_id":20,"style":")" +
                              style + R"(","position_m":[0.01,-0.02,0.4]})");
    const board::Grid grid{.columns = 4,
                           .rows = 3,
                           .edge_mm = 40,
                           .gap_mm = 14,
                           .style = style == "plain" ? board::Style::Plain : board::Style::Kalibr,
                           .border_cells = style == "plain" ? 1 : 2};
    std::vector<codec::TagId> ids;
    for (codec::TagId id = 20; id < 32; ++id) ids.push_back(id);
    const board::Board board = plan_grid(codec::find_family("tag36h11"), grid, ids);
    const Rendering rendering = render(scene);
    ASSERT_EQ(scene.tags.size(), 12U);
    ASSERT_EQ(rendering.truth.size(), 12U);
    for (std::size_t i = 0; i < 12; ++i) {
      EXPECT_EQ(scene.tags[i].id, board.tags[i].id);
      EXPECT_EQ(std::get<PosedTag>(scene.tags[i].place).edge_m, 0.04);
      const detect::Corners corners = border_corners(board.tags[i]);
      for (std::size_t k = 0; k < 4; ++k) {
        const Point expected = seen(1e-3 * corners[k], {0.01, -0.02}, 0.4);
        EXPECT_NEAR(rendering.truth[i].corners[k].x, expected.x, 1e-9);
        EXPECT_NEAR(rendering.truth[i].corners[k].y, expected.y, 1e-9);
      }
      EXPECT_NEAR(rendering.truth[i].visible, 1, 1e-6);
    }
  }
}

TEST(BoardScene, IsASheetOfWhiteWithBlackSquaresInTheStyleKalibr) {
  const std::string board = R"({"family":"tag36h11","grid":[2,2],"edge_m":0.08,"spacing":0.3,
      "position_m":[0,0,0.5],"style":)";
  // The middle of the board is between the tags; the gap is 0.024 m, 30.7 px.
  const detect::Image plain = render(parse(board + R"("plain"})")).image;
  EXPECT_EQ(plain.at(320, 240), 220);
  const detect::Image kalibr = render(parse(board + R"("kalibr"})")).image;
  EXPECT_EQ(kalibr.at(320, 240), 30);
  EXPECT_EQ(kalibr.at(320 - 14, 240 - 14), 30);  // also beside the tags' corners
  EXPECT_EQ(kalibr.at(320 + 14, 240 - 14), 30);
  EXPECT_EQ(kalibr.at(320, 240 - 60), 220);  // between two tags
  // The board's outer corner has a square of its own; beyond is the background.
  const double reach = 640 * (0.08 + 0.012 + 0.024) / 0.5;
  EXPECT_EQ(kalibr.at(320 - static_cast<int>(reach) + 2, 240), 30);
  EXPECT_EQ(kalibr.at(320 - static_cast<int>(reach) - 3, 240), 100);
}

TEST(BoardScene, TiltedIsReadByTheDetector) {
  const Scene scene = parse(R"({"family":"tag36h11","grid":[5,4],"edge_m":0.05,"spacing":0.3,
      "position_m":[0.01,0,0.5],"rotation_deg":[25,-30,10]})",
                            R"(,"blur_px":0.7,"noise":3)");
  const Rendering rendering = render(scene);
  detect::Detector detector(
      {std::make_shared<const codec::Decoder>(codec::find_family("tag36h11"))});
  test::Accuracy accuracy;
  test::add_accuracy(scene, rendering.truth, detector.detect(rendering.image), accuracy);
  EXPECT_EQ(accuracy.found, 20);
  EXPECT_EQ(accuracy.wrong, 0);
  EXPECT_LT(accuracy.median_px(), 0.1);
}

TEST(BoardScene, LaterBoardsAndTagsLieOnTop) {
  const std::string below = R"({"family":"tag36h11","grid":[2,1],"edge_m":0.1,"spacing":0.3,
      "position_m":[0,0,0.5]})";
  // The second board hides all of the first one, and the tag a part of the second.
  const Scene scene = parse(below + "," + R"({"family":"tag25h9","grid":[1,1],"edge_m":0.4,
      "position_m":[0,0,0.5]})",
                            R"(,"tags":[{"family":"tag16h5","id":3,"edge_m":0.08,
      "position_m":[0,0,0.5]}])");
  ASSERT_EQ(scene.tags.size(), 4U);
  const Rendering rendering = render(scene);
  EXPECT_NEAR(rendering.truth[0].visible, 0, 1e-6);
  EXPECT_NEAR(rendering.truth[1].visible, 0, 1e-6);
  EXPECT_GT(rendering.truth[2].visible, 0.5);
  EXPECT_LT(rendering.truth[2].visible, 0.99);
  EXPECT_NEAR(rendering.truth[3].visible, 1, 1e-6);
  const auto truth = nlohmann::json::parse(format_truth(scene, rendering.truth));
  EXPECT_EQ(truth.at("tags")[1].at("board"), 0);
  EXPECT_EQ(truth.at("tags")[2].at("board"), 1);
  EXPECT_FALSE(truth.at("tags")[3].contains("board"));
}

TEST(BoardScene, NamesWhatIsWrong) {
  const std::string begin = R"({"family":"tag36h11","edge_m":0.04,"position_m":[0,0,1],)";
  expect_fault(begin + R"("grid":[4]})", "boards[0].grid is no pair of numbers");
  expect_fault(begin + R"("grid":[4,0]})", "boards[0].grid[1] is 0");
  expect_fault(begin + R"("grid":[40,40]})", "boards[0].grid has 1600 places");
  expect_fault(begin + R"("grid":[4,3],"first_id":580})", "boards[0].first_id is 580");
  expect_fault(begin + R"("grid":[4,3],"spacing":0.1})", "boards[0] does not fit: a gap of 4 mm");
  expect_fault(begin + R"("grid":[4,3],"style":"round"})", "boards[0].style is 'round'");
  expect_fault(begin + R"("grid":[4,3],"gap":1})", "unknown key 'gap'");
  expect_fault(R"({"family":"tagStandard41h12","edge_m":0.04,"position_m":[0,0,1],"grid":[2,2],
      "style":"kalibr"})",
               "boards[0] cannot be: tagStandard41h12 has data outside its border square");
  expect_fault(R"({"family":"tag36h11","edge_m":0.04,"position_m":[0,0,-1],"grid":[2,2]})",
               "boards[0]: its middle lies behind the camera");
}

}  // namespace
}  // namespace tagmint::scene
