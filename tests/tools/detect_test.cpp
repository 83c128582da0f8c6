// `tagmint render` and `tagmint detect` as their users meet them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "io/images.h"
#include "support/generated_families.h"
#include "support/scratch_folder.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::test {
namespace {

using Json = nlohmann::json;

/// Renders a random scene into `folder`/NAME.png and .json.
void render(const ScratchFolder& folder, const std::string& name,
            const std::vector<std::string>& options) {
  std::vector<std::string> words = {
      "render", "-o", folder.file(name + ".png"), "--truth", folder.file(name + ".json"),
      "--quiet"};
  words.insert(words.end(), options.begin(), options.end());
  const ProgramResult result = tagmint(words);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "");
}

std::vector<Json> lines_of(const std::string& jsonl) {
  std::vector<Json> lines;
  std::size_t begin = 0;
  for (std::size_t end = jsonl.find('\n'); end != std::string::npos;
       end = jsonl.find('\n', begin)) {
    lines.push_back(Json::parse(jsonl.substr(begin, end - begin)));
    begin = end + 1;
  }
  return lines;
}

/// The same without the times, which differ from run to run.
std::vector<Json> timeless(const std::string& jsonl) {
  std::vector<Json> lines = lines_of(jsonl);
  for (Json& line : lines) line.erase("elapsed_ms");
  return lines;
}

TEST(DetectProgram, FindsWhatRenderDrewIdsCornersAndPoses) {
  const ScratchFolder folder;
  render(folder, "a",
         {"tag36h11", "--min-side", "50", "--noise", "5", "--blur", "1", "--max-tilt", "60"});
  const ProgramResult result =
      tagmint({"detect", "--family", "tag36h11", "--format", "jsonl", "--camera", "640,640,320,240",
               "--edge", "10cm", folder.file("a.png")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const std::vector<Json> lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 1U);
  std::map<int, Json> truth;
  const Json truth_file = Json::parse(read_file(folder.file("a.json")));
  for (const Json& tag : truth_file.at("tags")) truth[tag.at("id")] = tag;
  const Json& found = lines[0].at("detections");
  ASSERT_EQ(found.size(), 8U);
  ASSERT_EQ(truth.size(), 8U);
  std::vector<double> errors;
  for (const Json& tag : found) {
    ASSERT_TRUE(truth.count(tag.at("id")));
    const Json& real = truth[tag.at("id")];
    EXPECT_EQ(tag.at("family"), "tag36h11");
    for (int k = 0; k < 4; ++k) {
      errors.push_back(std::hypot(
          tag.at("corners")[k][0].get<double>() - real.at("corners")[k][0].get<double>(),
          tag.at("corners")[k][1].get<double>() - real.at("corners")[k][1].get<double>()));
    }
    const double distance = real.at("pose").at("t")[2];
    EXPECT_NEAR(tag.at("pose").at("t")[2].get<double>(), distance, 0.01 * distance);
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.1);
}

TEST(DetectProgram, SaysHowTrueCornersAndPosesAreUnlessToldNotToLook) {
  const ScratchFolder folder;
  render(folder, "a", {"tag36h11", "--count", "3", "--min-side", "50", "--noise", "2"});
  const auto first_tag = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words = {"detect",          "--family", "tag36h11",
                                      "--format",        "jsonl",    "--camera",
                                      "640,640,320,240", "--edge",   "10cm"};
    words.insert(words.end(), options.begin(), options.end());
    words.push_back(folder.file("a.png"));
    const ProgramResult result = tagmint(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return lines_of(result.out).at(0).at("detections").at(0);
  };
  const Json full = first_tag({});
  EXPECT_EQ(full.at("corner_covariance").size(), 64U);
  EXPECT_EQ(full.at("pose").at("covariance").size(), 36U);
  EXPECT_TRUE(full.contains("pose_ambiguous"));
  EXPECT_GT(full.at("log_odds").get<double>(), 10);
  EXPECT_FALSE(full.contains("mirrored"));
  for (const char* option : {"--no-photometric", "--no-refine"}) {
    const Json plain = first_tag({option});
    EXPECT_FALSE(plain.contains("corner_covariance")) << option;
    EXPECT_FALSE(plain.at("pose").contains("covariance")) << option;
    EXPECT_EQ(plain.at("id"), full.at("id"));
  }
  EXPECT_EQ(first_tag({"--unusual-prints"}).at("id"), full.at("id"));
}

TEST(DetectProgram, AnswersInTheOrderOfTheArgumentsWhateverTheThreads) {
  const ScratchFolder folder;
  std::vector<std::string> words = {"detect", "--family", "tag16h5", "--format", "jsonl"};
  std::vector<std::string> images;
  for (int i = 0; i < 6; ++i) {
    // Large and small pictures in turn: the small ones are done first.
    render(folder, std::to_string(i),
           {"tag16h5", "--seed", std::to_string(i), "--count", "3", "--size",
            i % 2 ? "200x150" : "640x480", "--min-side", "20", "--max-side", "30"});
    images.push_back(folder.file(std::to_string(i) + ".png"));
  }
  words.insert(words.end(), images.begin(), images.end());
  const ProgramResult one = [&] {
    std::vector<std::string> with = words;
    with.insert(with.end(), {"--threads", "1"});
    return tagmint(with);
  }();
  words.insert(words.end(), {"--threads", "4"});
  const ProgramResult four = tagmint(words);
  ASSERT_EQ(one.exit_code, 0) << one.err;
  ASSERT_EQ(four.exit_code, 0) << four.err;
  const std::vector<Json> lines = timeless(one.out);
  EXPECT_EQ(lines, timeless(four.out));
  ASSERT_EQ(lines.size(), images.size());
  for (std::size_t i = 0; i < images.size(); ++i) EXPECT_EQ(lines[i].at("image"), images[i]);
}

TEST(DetectProgram, GoesOnAfterAnImageThatCannotBeRead) {
  const ScratchFolder folder;
  render(folder, "good", {"tag36h11", "--count", "1"});
  write_file(folder.file("bad.png"), "no picture");
  const ProgramResult result =
      tagmint({"detect", "--family", "tag36h11", "--format", "jsonl", folder.file("missing.png"),
               folder.file("bad.png"), folder.file("good.png")});
  EXPECT_EQ(result.exit_code, 3);
  const std::vector<Json> lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].size(), 2U);
  EXPECT_EQ(lines[0].at("image"), folder.file("missing.png"));
  EXPECT_TRUE(lines[1].contains("error"));
  EXPECT_EQ(lines[2].at("detections").size(), 1U);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 2);
  EXPECT_TRUE(result.err.starts_with("tagmint: error: ")) << result.err;
}

TEST(DetectProgram, RequireAnswersOneWhenSomeImageHasNoTag) {
  const ScratchFolder folder;
  render(folder, "tags", {"tag36h11", "--count", "1"});
  io::write_png(folder.file("none.png"), detect::Image(64, 64, 90).view());
  const std::vector<std::string> words = {"detect", "--family", "tag36h11", "--require",
                                          folder.file("tags.png")};
  EXPECT_EQ(tagmint(words).exit_code, 0);
  std::vector<std::string> more = words;
  more.push_back(folder.file("none.png"));
  EXPECT_EQ(tagmint(more).exit_code, 1);
  more.push_back(folder.file("missing.png"));
  EXPECT_EQ(tagmint(more).exit_code, 3);
}

TEST(DetectProgram, FormatFollowsTheOutputFile) {
  const ScratchFolder folder;
  render(folder, "a", {"tag36h11", "--count", "2"});
  for (const std::string name : {"out.jsonl", "out.csv", "out.txt"}) {
    ASSERT_EQ(
        tagmint({"detect", "--family", "tag36h11", folder.file("a.png"), "-o", folder.file(name)})
            .exit_code,
        0);
  }
  EXPECT_EQ(lines_of(read_file(folder.file("out.jsonl"))).size(), 1U);
  EXPECT_TRUE(read_file(folder.file("out.csv")).starts_with("image,family,id,"));
  EXPECT_NE(read_file(folder.file("out.txt")).find("640 x 480 px, 2 tags"), std::string::npos);
}

TEST(DetectProgram, WritesOverlaysAndDebugPictures) {
  const ScratchFolder folder;
  render(folder, "a", {"tag36h11", "--count", "1"});
  render(folder, "b", {"tag36h11", "--count", "1", "--seed", "2"});
  const ProgramResult result =
      tagmint({"detect", "--family", "tag36h11", folder.file("a.png"), folder.file("b.png"),
               "--overlay", folder.file("{name}-found.png"), "--debug", folder.file("steps")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a-found.png", "a.json", "a.png",
                                                      "b-found.png", "b.json", "b.png", "steps"}));
  EXPECT_EQ(io::read_gray_image(folder.file("steps/b/7-detections.png")).width(), 640);
  EXPECT_EQ(io::read_gray_image(folder.file("a-found.png")).height(), 480);
  const ProgramResult into = tagmint({"detect", "--family", "tag36h11", folder.file("a.png"),
                                      folder.file("b.png"), "--overlay", folder.file("found/")});
  ASSERT_EQ(into.exit_code, 0) << into.err;
  EXPECT_EQ(io::read_gray_image(folder.file("found/b-overlay.png")).width(), 640);
}

TEST(DetectProgram, AFolderStandsForThePicturesInIt) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path() / "pictures");
  render(folder, "pictures/b", {"tag36h11", "--count", "1"});
  render(folder, "pictures/a", {"tag36h11", "--count", "2"});
  const ProgramResult result =
      tagmint({"detect", "--family", "tag36h11", "--format", "jsonl", folder.file("pictures")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::vector<Json> lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 2U);  // the truth files beside the pictures are none
  EXPECT_TRUE(lines[0].at("image").get<std::string>().ends_with("a.png"));
  EXPECT_EQ(lines[0].at("detections").size(), 2U);
  EXPECT_TRUE(lines[1].at("image").get<std::string>().ends_with("b.png"));
  std::filesystem::create_directory(folder.path() / "empty");
  EXPECT_EQ(tagmint({"detect", "--family", "tag36h11", folder.file("empty")}).exit_code, 3);
}

TEST(DetectProgram, BothAlgorithmsFindTheTagsAndTellTheirStages) {
  const ScratchFolder folder;
  render(folder, "a", {"tag36h11", "--count", "4"});
  for (const std::string algorithm : {"tracker", "paper"}) {
    const ProgramResult result =
        tagmint({"detect", "--family", "tag36h11", "--algorithm", algorithm, "--stats", "--format",
                 "jsonl", folder.file("a.png")});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(lines_of(result.out).at(0).at("detections").size(), 4U) << algorithm;
    const bool tracker = algorithm == "tracker";
    EXPECT_EQ(result.err.find("bitmap") != std::string::npos, tracker);
    EXPECT_EQ(result.err.find("fit_quads") != std::string::npos, !tracker);
  }
  EXPECT_EQ(
      tagmint({"detect", "--family", "tag36h11", "--algorithm", "trackr", folder.file("a.png")})
          .exit_code,
      2);
}

TEST(DetectProgram, LooksForTheIdsThatWereAskedFor) {
  const ScratchFolder folder;
  render(folder, "a", {"tag36h11", "--ids", "3-6"});
  const ProgramResult result = tagmint({"detect", "--family", "tag36h11", "--ids", "4,6-",
                                        "--format", "jsonl", folder.file("a.png")});
  const Json found = lines_of(result.out).at(0).at("detections");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].at("id"), 4);
  EXPECT_EQ(found[1].at("id"), 6);
}

TEST(DetectProgram, TheIdsInUseDecideTheSafeRadius) {
  const ScratchFolder folder;
  const std::string path = folder.file("levels.json");
  const codec::Family family(generated_36());
  codec::write_family(family, path);
  // Pictures of tags with seven wrong cells each.
  codec::FamilyParts damaged{"damaged", family.layout(), 1, {}, {}, {}, {}};
  for (const codec::TagId id : {7U, 59U}) {
    damaged.codewords.push_back(family.codeword(id) ^ 0x900a00811);
  }
  codec::write_family(codec::Family(damaged), folder.file("damaged.json"));
  render(folder, "a", {folder.file("damaged.json"), "--count", "2", "--min-side", "60"});
  const std::string image = folder.file("a.png");
  const ProgramResult result = tagmint({"detect", "--family", path, "--ids", "0-59",
                                        "--max-hamming", "7", "--format", "jsonl", image});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json found = lines_of(result.out).at(0).at("detections");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].at("id"), 7);
  EXPECT_EQ(found[1].at("id"), 59);
  EXPECT_EQ(found[0].at("hamming"), 7);
  EXPECT_EQ(found[1].at("hamming"), 7);
  expect_fault({"detect", "--family", path, "--max-hamming", "7", image}, 2,
               "7 bit errors are more than the 3 that generated36 corrects safely with distance 8 "
               "(--max-hamming); ask for 0 to 3, or add --unsafe-radius");
}

TEST(DetectProgram, StatsGoToStderr) {
  const ScratchFolder folder;
  render(folder, "a", {"tag36h11", "--count", "1"});
  const ProgramResult result =
      tagmint({"detect", "--family", "tag36h11", "--stats", folder.file("a.png")});
  EXPECT_NE(result.err.find("quads"), std::string::npos);
  EXPECT_NE(result.err.find("reconcile"), std::string::npos);
  EXPECT_EQ(result.out.find("reconcile"), std::string::npos);
}

TEST(DetectProgram, AFixedContrastLetsNoiseThrough) {
  const ScratchFolder folder;
  render(folder, "a", {"tag36h11", "--count", "1", "--noise", "8"});
  const auto boundary_points = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words = {"detect",      "--family", "tag36h11",
                                      "--algorithm", "paper",    "--stats"};
    words.insert(words.end(), options.begin(), options.end());
    words.push_back(folder.file("a.png"));
    const std::string text = tagmint(words).err;
    const std::string name = "boundary points";
    return std::stoi(text.substr(text.find(name) + name.size()));
  };
  EXPECT_LT(4 * boundary_points({}), boundary_points({"--fixed-contrast"}));
}

TEST(DetectProgram, RefusesNumbersOutOfRange) {
  for (const auto& [option, value, range] :
       {std::array{"--blur", "1e6", "-100 to 100"}, std::array{"--blur", "nan", "-100 to 100"},
        std::array{"--decimate", "0", "1 to 1000"},
        std::array{"--min-margin", "nan", "0 to 255"}}) {
    expect_fault({"detect", "--family", "tag36h11", "a.png", option, value}, 2,
                 fmt::format("'{}' is not a number from {} ({}); see 'tagmint detect --help'",
                             value, range, option));
  }
}

TEST(DetectProgram, RefusesOptionsThatDoNotGoTogether) {
  const ScratchFolder folder;
  io::write_png(folder.file("a.png"), detect::Image(64, 64, 90).view());
  const std::string image = folder.file("a.png");
  const auto refused = [&](std::vector<std::string> options, const std::string& fault) {
    options.insert(options.begin(), "detect");
    options.push_back(image);
    expect_fault(options, 2, fault);
  };
  const std::string f = "--family";
  refused({f, "tag16h5", "--max-hamming", "3"},
          "3 bit errors are more than the 2 that tag16h5 corrects safely with distance 5 "
          "(--max-hamming); ask for 0 to 2, or add --unsafe-radius");
  refused({f, "tag16h5", f, "tag16h5"},
          "the family tag16h5 is given twice (--family); give each once");
  refused({f, "tag16h5", "--edge", "40mm"},
          "poses need the camera (--edge); add --camera FX,FY,CX,CY");
  refused({f, "tag16h5", "--camera", "600,600,320,240"},
          "poses need the side of the border square (--camera); add --edge LEN, for example "
          "--edge 40mm");
  refused({f, "tag16h5", "--edge", "40mm", "--camera", "600,600,320"},
          "'600,600,320' has 3 numbers, 4 are needed (--camera); give FX,FY,CX,CY in pixels");
  refused({f, "tag16h5", "--overlay", "x.jpg"},
          "'x.jpg' does not end in .png (--overlay); overlays are PNG files");
  refused({f, "tag16h5", "--overlay", image},
          "the overlay would replace the image " + image + " (--overlay); choose another name");
  refused({f, "tag16h5", "--overlay", folder.file("o.png"), "b.png"},
          "b.png and " + image + " would both be written to " + folder.file("o.png") +
              " (--overlay); use {name} in the file's name and images of different names, or give "
              "them one by one");
  EXPECT_EQ(
      tagmint({"detect", f, "tag16h5", "--max-hamming", "3", "--unsafe-radius", image}).exit_code,
      0);
}

TEST(RenderProgram, DrawsASceneFileTheSameEveryTime) {
  const ScratchFolder folder;
  write_file(folder.file("scene.json"),
             R"({"width":320,"height":240,"noise":4,"background":{"texture":{}},"tags":[
                {"family":"tag36h11","id":5,"edge_m":0.1,"position_m":[0,0,0.5]}]})");
  for (const std::string name : {"1.png", "2.pgm"}) {
    ASSERT_EQ(tagmint({"render", folder.file("scene.json"), "-o", folder.file(name)}).exit_code, 0);
  }
  EXPECT_EQ(io::read_gray_image(folder.file("1.png")), io::read_gray_image(folder.file("2.pgm")));
  EXPECT_TRUE(read_file(folder.file("2.pgm")).starts_with("P5"));
}

TEST(RenderProgram, WithoutACountDrawsWhatFindsRoom) {
  const ScratchFolder folder;
  const ProgramResult result =
      tagmint({"render", "tagCircle49h12", "--size", "320x240", "-o", folder.file("few.png")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(result.err.starts_with("tagmint: 320 x 240 px, ")) << result.err;
}

TEST(RenderProgram, TellsFaultsInOneLine) {
  const ScratchFolder folder;
  const std::string out = folder.file("x.png");
  write_file(folder.file("scene.json"), R"({"width":320,"height":240})");
  expect_fault({"render", folder.file("scene.json"), "-o", out}, 3,
               "the scene lacks 'tags' (" + folder.file("scene.json") + "); add it");
  expect_fault({"render", folder.file("scene.json"), "-o", out, "--noise", "3"}, 2,
               "--noise is for random scenes (" + folder.file("scene.json") +
                   "); write it into the scene file");
  expect_fault({"render", "tag36h11", "-o", out, "--size", "640"}, 2,
               "'640' is no image size (--size); give WIDTHxHEIGHT in pixels, 1 to 16384 each, "
               "like 640x480");
  expect_fault({"render", "tag36h11", "-o", out, "--background", "textur"}, 2,
               "'textur' is neither a background nor a file (--background); give gray:LEVEL, "
               "gradient:FROM,TO, texture, texture:GRAY,AMPLITUDE, clutter, clutter:SHAPES or a "
               "picture");
  expect_fault({"render", "tag36h11", "-o", out, "--background", "clutter:2.5"}, 2,
               "clutter of 2.5 shapes cannot be (--background); give a whole number from 0 to "
               "1000000");
  expect_fault({"render", "tag36h11", "-o", out, "--motion-blur", "6,x"}, 2,
               "'x' is no number (--motion-blur); give LENGTH or LENGTH,ANGLE");
  for (const auto& [option, value, range] :
       {std::array{"--noise", "nan", "0 to 255"}, std::array{"--blur", "inf", "0 to 1000"},
        std::array{"--shading", "nan", "0 to 0.99"}, std::array{"--max-tilt", "-5", "0 to 85"},
        std::array{"--min-side", "nan", "1 to 16384"}}) {
    expect_fault({"render", "tag36h11", "-o", out, option, value}, 2,
                 fmt::format("'{}' is not a number from {} ({}); see 'tagmint render --help'",
                             value, range, option));
  }
  for (const char* seed : {"-1", "1.5", "99999999999999999999"}) {
    expect_fault({"render", "tag36h11", "-o", out, "--seed", seed}, 2,
                 fmt::format("'{}' is not a seed (--seed); write a whole number from 0 to {}", seed,
                             "18446744073709551615"));
  }
  expect_fault({"render", "tag36h11", "-o", out, "--truth", out}, 2,
               "image and truth would be the same file (--truth); give each its own");
  const ProgramResult crowded = tagmint({"render", "tag36h11", "-o", out, "--count", "500"});
  EXPECT_EQ(crowded.exit_code, 2);
  EXPECT_NE(crowded.err.find("of 500 tags found room"), std::string::npos) << crowded.err;
  EXPECT_EQ(tagmint({"render", "tag36h12", "-o", out}).exit_code, 3);
  EXPECT_EQ(tagmint({"render", "tag36h11"}).exit_code, 2);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"scene.json"}));
}

}  // namespace
}  // namespace tagmint::test
