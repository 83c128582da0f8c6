// `tagmint evaluate` run from outside.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "io/images.h"
#include "scene/render.h"
#include "support/scratch_folder.h"
#include "support/tagmint_program.h"

namespace tagmint::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kNames = {"distance", "angle",           "range",
                                         "mosaic",   "false-positives", "timing",
                                         "families", "robustness",      "codec"};

std::vector<std::string> arguments(const std::string& experiment, const ScratchFolder& folder,
                                   const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"evaluate", experiment,   "--quick", "--samples",
                                    "1",        "--no-peers", "-o",      folder.path().string()};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Columns that the head explains, and those of the rows, which must agree.
void expect_sound_csv(const std::string& csv, std::size_t least_rows) {
  std::istringstream stream(csv);
  std::vector<std::string> explained;
  std::vector<std::string> lines;
  bool columns = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("#")) {
      if (columns) explained.push_back(line.substr(4, line.find("  ", 4) - 4));
      columns = columns || line == "# Columns:";
    } else {
      lines.push_back(line);
    }
  }
  ASSERT_GT(lines.size(), least_rows);
  std::string header;
  for (const std::string& name : explained) header += (header.empty() ? "" : ",") + name;
  EXPECT_EQ(lines[0], header);
  const auto commas = std::count(header.begin(), header.end(), ',');
  for (const std::string& line : lines) {
    if (line.find('"') == std::string::npos) {
      EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas) << line;
    }
  }
}

void expect_results(const ScratchFolder& folder, const std::string& name, std::size_t least_rows) {
  SCOPED_TRACE(name);
  expect_sound_csv(read_file(folder.file(name + ".csv")), least_rows);
  const std::string svg = read_file(folder.file(name + ".svg"));
  EXPECT_NE(svg.find("<title>"), std::string::npos);
  EXPECT_NE(svg.find(" against "), std::string::npos);
  EXPECT_NE(svg.find("tagmint"), std::string::npos);
  EXPECT_LT(svg.size(), 300'000U);
  EXPECT_GT(io::read_gray_image(folder.file(name + ".png")).width(), 600);
  EXPECT_FALSE(fs::exists(folder.file(name + ".points")));
}

TEST(EvaluateProgram, ListsTheExperiments) {
  const ProgramResult result = tagmint({"evaluate"});
  EXPECT_EQ(result.exit_code, 0);
  for (const std::string& name : kNames) {
    EXPECT_TRUE(result.out.find("\n" + name + " ") != std::string::npos ||
                result.out.starts_with(name + " "))
        << name;
  }
  expect_fault({"evaluate", "distnace"}, 2,
               "there is no experiment 'distnace' (EXPERIMENT); did you mean 'distance'?");
}

TEST(EvaluateProgram, TinyRunsGiveTablesAndFigures) {
  const ScratchFolder folder;
  for (const std::string name : {"distance", "angle", "range", "mosaic", "robustness"}) {
    const ProgramResult result = tagmint(arguments(name, folder));
    ASSERT_EQ(result.exit_code, 0) << name << result.err;
    EXPECT_NE(result.out.find("tagmint"), std::string::npos) << result.out;
    expect_results(folder, name, 20);
  }
}

TEST(EvaluateProgram, NearTagsAreFoundAtTheirDistance) {
  const ScratchFolder folder;
  ASSERT_EQ(tagmint(arguments("distance", folder)).exit_code, 0);
  std::istringstream csv(read_file(folder.file("distance.csv")));
  int judged = 0;
  for (std::string line; std::getline(csv, line);) {
    double distance = 0, side = 0, share = 0, error = 0;
    int tags = 0, found = 0, wrong = 0;
    if (std::sscanf(line.c_str(), "%lf,%lf,tagmint,1,%d,%d,%lf,%d,%lf", &distance, &side, &tags,
                    &found, &share, &wrong, &error) != 7 ||
        distance > 5) {
      continue;
    }
    ++judged;
    EXPECT_EQ(share, 1) << line;
    EXPECT_EQ(wrong, 0) << line;
    EXPECT_NEAR(side * distance, 100.2, 0.01);
    EXPECT_LT(error, 0.01) << line;  // 0.2 % of 5 m
  }
  EXPECT_GE(judged, 8);
}

TEST(EvaluateProgram, ResultsDependOnTheSeedAndNotOnThreads) {
  const ScratchFolder one, two, other;
  ASSERT_EQ(tagmint(arguments("robustness", one, {"--threads", "1"})).exit_code, 0);
  ASSERT_EQ(tagmint(arguments("robustness", two, {"--threads", "3"})).exit_code, 0);
  ASSERT_EQ(tagmint(arguments("robustness", other, {"--seed", "2"})).exit_code, 0);
  for (const char* file : {"robustness.csv", "robustness.svg", "robustness.png"}) {
    EXPECT_EQ(read_file(one.file(file)), read_file(two.file(file))) << file;
  }
  EXPECT_NE(read_file(one.file("robustness.csv")), read_file(other.file("robustness.csv")));
}

/// Waits until so many lines are in the file of points.
bool wait_for_points(const std::string& path, int lines) {
  for (int i = 0; i < 3000; ++i) {
    std::ifstream file(path);
    int count = 0;
    for (std::string line; std::getline(file, line);) ++count;
    if (count >= lines) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

TEST(EvaluateProgram, RunThatIsKilledOrInterruptedGoesOnToTheSameBytes) {
  const ScratchFolder whole;
  std::vector<std::string> words = {"evaluate", "robustness", "--no-peers", "--samples", "1", "-o"};
  words.push_back(whole.path().string());
  ASSERT_EQ(tagmint(words).exit_code, 0);
  for (const int signal : {SIGKILL, SIGINT}) {
    const ScratchFolder folder;
    words.back() = folder.path().string();
    RunningProgram program(tagmint_words(words));
    ASSERT_TRUE(wait_for_points(folder.file("robustness.points"), 4));
    program.send_signal(signal);
    const ProgramResult ended = program.finish();
    EXPECT_EQ(ended.exit_code, signal == SIGKILL ? 128 + SIGKILL : 130);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"robustness.points"});
    const ProgramResult result = tagmint(words);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("going on after"), std::string::npos) << result.err;
    for (const char* file : {"robustness.csv", "robustness.svg", "robustness.png"}) {
      EXPECT_EQ(read_file(folder.file(file)), read_file(whole.file(file))) << file;
    }
  }
}

TEST(EvaluateProgram, PointsOfOtherSettingsAreRefused) {
  const ScratchFolder folder;
  const std::string path = folder.file("angle.points");
  std::ofstream(path) << "{\"tagmint_points\":1,\"run\":{\"seed\":5}}\n";
  expect_fault(arguments("angle", folder), 3,
               "the points in this file are those of a run with other settings (" + path +
                   "); begin anew with --restart, or take another folder with -o");
  EXPECT_EQ(tagmint(arguments("angle", folder, {"--restart"})).exit_code, 0);
}

TEST(EvaluateProgram, PeersThatCannotBeOpenedAreToldAndTakeNoPart) {
  const ScratchFolder folder, peers;
  std::ofstream(peers.file("broken.so")) << "no library";
  const ProgramResult result =
      RunningProgram(tagmint_words({"evaluate", "angle", "--quick", "--samples", "1", "-o",
                                    folder.path().string()}),
                     Stderr::Pipe, {"TAGMINT_PEERS=" + peers.path().string()})
          .finish();
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("tagmint: goes without broken: "), std::string::npos) << result.err;
  EXPECT_EQ(read_file(folder.file("angle.csv")).find("libapriltag"), std::string::npos);
}

TEST(EvaluateProgram, FalsePositivesCountsQuadsAndNeedsPhotographs) {
  const ScratchFolder folder, pictures;
  expect_fault(arguments("false-positives", folder), 3,
               "there are no photographs (--photographs); name a folder of pictures without tags; "
               "tools/fetch_photographs.sh makes one");
  scene::Scene scene;
  scene.camera = scene::default_camera(scene.width, scene.height);
  scene.background = scene::ClutterBackground{};
  io::write_png(pictures.file("a.png"), scene::render(scene).image.view());
  const ProgramResult result =
      tagmint(arguments("false-positives", folder, {"--photographs", pictures.path().string()}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  expect_results(folder, "false-positives", 20);
  const std::string csv = read_file(folder.file("false-positives.csv"));
  // Two errors or fewer of 36 bits, 587 tags: the paper's 0.000570 %, and four times that.
  EXPECT_NE(csv.find(",all,0,0,5.6975e-06,2.279e-05,0\n"), std::string::npos) << csv;
}

TEST(EvaluateProgram, FamilyGetsAPageOfItsOwn) {
  const ScratchFolder folder;
  const ProgramResult result = tagmint({"evaluate", "--family", "tag16h5", "--quick", "--samples",
                                        "1", "--no-peers", "-o", folder.path().string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string page = read_file(folder.file("tag16h5.html"));
  for (const char* part : {"<h1>tag16h5</h1>", "tag36h11", "id=\"found\"", "id=\"mistaken\"",
                           "side of the whole tag, px", "off-axis angle, degrees",
                           "noise, gray levels", "default-src 'none'", "</html>"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  for (const char* outside : {"src=\"http", "href=\"http", "<?xml", "@import"}) {
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  }
  expect_results(folder, "family", 60);
}

}  // namespace
}  // namespace tagmint::test
