// `tagmint board` and `tagmint poster` as they are called: files, messages, faults.
#include "cli/cmd_board.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/program.h"
#include "io/images.h"
#include "support/scratch_folder.h"

namespace tagmint::cli {
namespace {

using test::read_file;

/// What a call of the program left.
struct Outcome {
  int code = 0;
  std::string messages;  // stderr
};

class BoardCommand : public ::testing::Test {
 protected:
  Outcome run(std::vector<std::string> arguments) const {
    std::vector<const char*> argv = {"tagmint"};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    ::testing::internal::CaptureStderr();
    const int code = run_program(static_cast<int>(argv.size()), argv.data());
    return {code, ::testing::internal::GetCapturedStderr()};
  }
  std::string file(const std::string& name) const { return folder_.file(name); }

  /// Expects one line with `part`, that exit code, and no file.
  void expect_refused(const std::vector<std::string>& arguments, int code,
                      const std::string& part) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << outcome.messages;
    EXPECT_EQ(std::count(outcome.messages.begin(), outcome.messages.end(), '\n'), 1);
    EXPECT_NE(outcome.messages.find(part), std::string::npos) << outcome.messages;
    EXPECT_EQ(folder_.names(), std::vector<std::string>{});
  }

  const test::ScratchFolder folder_;
};

using PosterCommand = BoardCommand;

TEST_F(BoardCommand, WritesTheBoardAndItsConfigs) {
  const Outcome outcome =
      run({"board", "tag36h11", "--grid", "4x3", "--edge", "40mm", "--style", "kalibr", "--config",
           file("target.yaml"), file("board.json"), "-o", file("b.pdf")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.messages,
            file("b.pdf") + ": 12 tags on a page of 220 mm x " + "193.9 mm\n" +
                "  tag36h11: edge 40 mm, outer 48 mm, ids 0-11\n"
                "  4 x 3 tags, ids from the bottom left, spacing 0.3 (gap 12 mm), border of 2 "
                "cells\n" +
                file("target.yaml") + ": kalibr\n" + file("board.json") + ": tagmint\n");
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"b.pdf", "board.json", "target.yaml"}));
  EXPECT_EQ(read_file(file("b.pdf")).substr(0, 5), "%PDF-");
  EXPECT_EQ(read_file(file("target.yaml")),
            "# tag36h11: edge 40 mm, outer 48 mm, ids 0-11\n"
            "# 4 x 3 tags, ids from the bottom left, spacing 0.3 (gap 12 mm), border of 2 cells\n"
            "target_type: 'aprilgrid'\n"
            "tagCols: 4\n"
            "tagRows: 3\n"
            "tagSize: 0.04  # edge of a tag's black border, m\n"
            "tagSpacing: 0.3  # gap between tags / tagSize\n");
  EXPECT_EQ(nlohmann::json::parse(read_file(file("board.json"))).at("tags").size(), 12u);
}

TEST_F(BoardCommand, APageOfTheBoardsSize) {
  const Outcome outcome = run({"board", "tag36h11", "--grid", "2x1", "--edge", "80mm", "--spacing",
                               "20mm", "--no-notes", "--dpi", "25.4", "-o", file("b.png")});
  EXPECT_EQ(outcome.code, 0) << outcome.messages;
  const detect::Image image = io::read_gray_image(file("b.png"));
  EXPECT_EQ(image.width(), 200);
  EXPECT_EQ(image.height(), 100);
}

TEST_F(BoardCommand, EachKindOfConfigByNameOrPrefix) {
  const Outcome outcome = run({"board", "tag36h11", "--grid", "3x2", "--edge", "40mm", "--first-id",
                               "5", "--config", file("tags.yaml"), "ros2:" + file("any.txt"),
                               file("my-wpilib.json"), "-o", file("b.svg")});
  EXPECT_EQ(outcome.code, 0) << outcome.messages;
  EXPECT_NE(read_file(file("tags.yaml")).find("standalone_tags:"), std::string::npos);
  EXPECT_NE(read_file(file("any.txt")).find("ros__parameters:"), std::string::npos);
  for (const char* name : {"tags.yaml", "any.txt"}) {
    EXPECT_NE(read_file(file(name)).find("# tag36h11: edge 40 mm, outer 50 mm, ids 5-10\n"),
              std::string::npos)
        << name;
  }
  EXPECT_NE(read_file(file("my-wpilib.json")).find("\"ID\": 5"), std::string::npos);
}

TEST_F(BoardCommand, BundlesFromOptionsAndFilesAreTheSame) {
  const std::string bundle = folder_.write("in.json", R"({"tags": [
    {"family": "tag36h11", "id": 0, "edge_mm": 60, "center_mm": [0, 0]},
    {"family": "tag25h9", "id": 1, "edge_mm": 30, "center_mm": [70, -10], "turn_deg": 30}]})");
  EXPECT_EQ(run({"board", "--bundle", bundle, "-o", file("a.svg")}).code, 0);
  EXPECT_EQ(run({"board", "--tag", "tag36h11:0:6cm@0mm,0mm", "--tag",
                 "tag25h9:1:30mm@7cm,-1cm,30deg", "-o", file("b.svg")})
                .code,
            0);
  EXPECT_EQ(read_file(file("a.svg")), read_file(file("b.svg")));
}

TEST_F(BoardCommand, NestedTagsTellBothSizes) {
  const Outcome outcome = run({"board", "tagCustom48h12", "--grid", "1x1", "--edge", "90mm",
                               "--nested", "tag36h11:7", "-o", file("n.pdf")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.messages.find("tagCustom48h12: edge 90 mm, outer 150 mm, id 0\n"),
            std::string::npos)
      << outcome.messages;
  EXPECT_NE(outcome.messages.find("tag36h11: edge 24 mm, outer 30 mm, in the hole, id 7\n"),
            std::string::npos)
      << outcome.messages;
}

TEST_F(BoardCommand, SquaresThatADetectorStumblesOverAreWarnedOf) {
  const Outcome outcome =
      run({"board", "tag36h11", "--grid", "3x2", "--edge", "40mm", "--style", "kalibr", "--border",
           "1", "--config", "ros1:" + file("t.yaml"), "-o", file("b.pdf")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.messages.find("tagmint: warning: ros1 uses a detector that follows"), 0u)
      << outcome.messages;
}

TEST_F(BoardCommand, UsualGapIsWideEnoughForEveryLayout) {
  const Outcome outcome =
      run({"board", "tagStandard41h12", "--grid", "2x2", "--edge", "40mm", "-o", file("s.pdf")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.messages.find("spacing 1 (gap 40 mm)"), std::string::npos) << outcome.messages;
}

TEST_F(BoardCommand, WrongBoardsAreNamedAndNothingIsWritten) {
  const std::string out = file("b.pdf");
  const auto refused = [&](std::vector<std::string> arguments, const std::string& part) {
    arguments.insert(arguments.begin(), "board");
    arguments.insert(arguments.end(), {"-o", out});
    expect_refused(arguments, 2, part);
  };
  refused({"tag36h11", "--grid", "0x3", "--edge", "40mm"}, "'0x3' is not a grid (--grid)");
  refused({"tag36h11", "--grid", "3x3"}, "the size of the tags is missing (--edge)");
  refused({"tag36h11", "--edge", "40mm"}, "no board is told (--grid)");
  refused({"--grid", "3x3", "--edge", "40mm"}, "FAMILY is missing");
  refused({"tag16h5", "--grid", "6x6", "--edge", "40mm"},
          "the grid has 36 places, and tag16h5 has ids 0-29 (--grid)");
  refused({"tag36h11", "--grid", "2x2", "--edge", "40mm", "--ids", "0-2"},
          "a grid of 2 x 2 has 4 places, and 3 ids were given");
  refused({"tag36h11", "--grid", "2x2", "--edge", "40mm", "--first-id", "585"}, "--first-id");
  refused({"tag36h11", "--grid", "2x2", "--edge", "40mm", "--spacing", "-0.3"}, "(--spacing)");
  refused({"tag36h11", "--grid", "2x2", "--edge", "40mm", "--spacing", "0.1"},
          "give at least --spacing 0.125 or 5mm");
  refused({"tag36h11", "--grid", "2x2", "--edge", "40"}, "has no unit (--edge)");
  refused({"tag36h11", "--grid", "2x2", "--edge", "400mm", "--paper", "a4"}, "does not fit");
  refused({"tag36h11", "--grid", "4x2", "--edge", "50mm", "--paper", "a4"},
          "turn the paper: it fits then");
  refused({"tag36h11", "--grid", "200x2", "--edge", "50mm"}, "larger than the limit");
  refused({"tagStandard41h12", "--grid", "2x2", "--edge", "40mm", "--style", "kalibr"},
          "has data outside its border square");
  refused({"tagCustom48h12", "--grid", "1x1", "--edge", "90mm", "--nested", "tag36h11:7:25mm"},
          "too large for the hole");
  refused({"tag36h11", "--grid", "1x1", "--edge", "90mm", "--nested", "tag16h5:7"},
          "tag36h11 has no hole for another tag");
  refused({"tag36h11", "--grid", "2x2", "--edge", "40mm", "--config", "kalibr:k.yaml"},
          "Kalibr's target file cannot say this board");
  refused({"tag36h11", "--grid", "2x2", "--edge", "40mm", "--config", "kalib:k.yaml"},
          "'kalib' is no kind of config (--config); did you mean 'kalibr'?");
  refused({"tag36h11", "--grid", "2x2", "--edge", "40mm", "--config", "board.yaml"},
          "does not tell which kind of config is meant (--config)");
  refused({"tag36h11", "--grid", "2x2", "--edge", "40mm", "--config", "ros1:-", "ros2:-"},
          "two results would go to stdout");
  refused({"tag36h11", "--tag", "tag36h11:0:60mm@0mm,0mm"}, "tag36h11 has no meaning for a bundle");
  refused({"--tag", "tag36h11:0:60mm@0mm,0mm", "--edge", "4cm"}, "--edge has no meaning");
  refused({"--tag", "tag36h11:0:60mm@0mm,0mm", "--grid", "1x1"}, "a grid or a bundle, not both");
  refused({"--tag", "tag36h11:0:60mm@0mm,0mm", "--tag", "tag36h11:1:60mm@5mm,0mm"},
          "stand too near");
  refused({"tag36h11", "--grid", "2x2", "--edge", "40mm", "--landscape"}, "no paper to turn");
}

TEST_F(BoardCommand, ConfigsThatCannotBeWrittenKeepTheBoardAway) {
  const std::vector<std::string> board = {"board",  "tag36h11", "--grid", "2x2",
                                          "--edge", "40mm",     "-o",     file("b.pdf")};
  auto to_no_folder = board;
  to_no_folder.insert(to_no_folder.end(), {"--config", "ros1:" + file("no/tags.yaml")});
  expect_refused(to_no_folder, 4, "there is no folder");
  auto to_full_device = board;
  to_full_device.insert(to_full_device.end(), {"--config", "ros1:/dev/full"});
  expect_refused(to_full_device, 4, "No space left on device");
  auto twice = board;
  twice.insert(twice.end(), {"--config", "ros1:" + file("b.pdf")});
  expect_refused(twice, 4, "two results would be written to one file");
}

TEST_F(PosterCommand, TellsSizesPagesAndPaper) {
  const Outcome outcome = run({"poster", "tag36h11", "7", "--edge", "360mm", "-o", file("p.pdf")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.messages,
            file("p.pdf") +
                ": 6 pages, the first is the map\n"
                "  tag36h11 7: edge 360 mm, outer 450 mm\n"
                "  poster with its quiet zone: 450 mm x 450 mm\n"
                "  pages: 3 of 210 mm x 297 mm and 2 of 297 mm x 210 mm, overlap 10 mm\n");
  EXPECT_EQ(read_file(file("p.pdf")).substr(0, 5), "%PDF-");
}

TEST_F(PosterCommand, OuterSizeOrientationAndPostScript) {
  const Outcome outcome = run({"poster", "tagCustom48h12", "7", "--outer", "50cm", "--nested",
                               "tag36h11:3", "--portrait", "-o", file("p.ps")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.messages.find("tagCustom48h12 7: edge 300 mm, outer 500 mm"),
            std::string::npos);
  EXPECT_NE(outcome.messages.find("tag36h11 3 in the hole: edge 80 mm, outer 100 mm"),
            std::string::npos);
  EXPECT_NE(outcome.messages.find("pages: 12 of 210 mm x 297 mm, overlap"), std::string::npos)
      << outcome.messages;
  EXPECT_EQ(read_file(file("p.ps")).substr(0, 4), "%!PS");
}

TEST_F(PosterCommand, WrongPostersAreNamedAndNothingIsWritten) {
  const std::string out = file("p.pdf");
  const auto refused = [&](std::vector<std::string> arguments, const std::string& part) {
    arguments.insert(arguments.begin(), "poster");
    arguments.insert(arguments.end(), {"-o", out});
    expect_refused(arguments, 2, part);
  };
  refused({"tag36h11", "7"}, "the size of the tag is missing (--edge)");
  refused({"tag36h11", "587", "--edge", "400mm"}, "id 587 is not in the family (ID)");
  refused({"tag36h11", "1,2", "--edge", "400mm"}, "'1,2' is more than one id (ID)");
  refused({"tag36h11", "1", "--edge", "0mm"}, "(--edge)");
  refused({"tag36h11", "1", "--edge", "400mm", "--margin", "3mm"}, "it is at least 6");
  refused({"tag36h11", "1", "--edge", "400mm", "--overlap", "150mm"}, "leave too little");
  refused({"tag36h11", "1", "--edge", "400mm", "--overlap", "-1mm"}, "negative (--overlap)");
  refused({"tag36h11", "1", "--edge", "900m"}, "the limit is 10000");
  refused({"tag36h11", "1", "--edge", "400mm", "--nested", "tag16h5:1"}, "no hole");
  expect_refused({"poster", "tag36h11", "1", "--edge", "400mm", "-o", file("p.png")}, 2,
                 "names no format");
  expect_refused({"poster", "tag36h11", "1", "--edge", "400mm", "-o", file("no/p.pdf")}, 4,
                 "there is no folder");
}

}  // namespace
}  // namespace tagmint::cli
