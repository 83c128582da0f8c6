// `tagmint identify` as its users meet it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/images.h"
#include "support/scratch_folder.h"
#include "support/tag_pictures.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::test {
namespace {

using Json = nlohmann::json;

/// A print of a tag in a file of its own.
std::string saved(const ScratchFolder& folder, const std::string& name,
                  const detect::Image& picture) {
  io::write_png(folder.file(name), picture);
  return folder.file(name);
}

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST(IdentifyProgram, SaysWhatBecameOfAPrint) {
  const ScratchFolder folder;
  const auto family = codec::find_family("tag36h11");
  const std::string file =
      saved(folder, "a.png",
            turned(mirrored(inverted(print_tag(*family, 7, {.cell_px = 8, .quiet_cells = 1}))), 1));
  const ProgramResult result = tagmint({"identify", file});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out.find(file + ": 96 x 96 px, one tag\ntag36h11 id 7\n"), 0u) << result.out;
  for (const char* line :
       {"mirrored left to right, then turned clockwise by 90 degrees; inverted: black and white "
        "are "
        "exchanged\n",
        "border      whole\n", "wrong       0 of 36 cells\n",
        "OpenCV 4    DICT_APRILTAG_36h11 id 7, turned clockwise by 270 degrees\n"}) {
    EXPECT_NE(result.out.find(line), std::string::npos) << line << result.out;
  }
}

TEST(IdentifyProgram, JsonHasItsShape) {
  const ScratchFolder folder;
  const auto family = codec::find_family("tag36h9");
  const std::string file =
      saved(folder, "a.png", print_tag(*family, 12, {.cell_px = 6, .quiet_cells = -1}));
  const ProgramResult result = tagmint({"identify", file, "--format", "json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json found = Json::parse(result.out);
  EXPECT_EQ(keys_of(found),
            (std::vector<std::string>{"height", "image", "nearest", "tags", "width"}));
  EXPECT_EQ(found["width"], 48);
  EXPECT_TRUE(found["nearest"].is_null());
  ASSERT_EQ(found["tags"].size(), 1u);
  const Json& candidates = found["tags"][0]["candidates"];
  ASSERT_EQ(candidates.size(), 2u);
  EXPECT_EQ(keys_of(candidates[0]),
            (std::vector<std::string>{"bits", "border", "corners", "expected_accidents", "family",
                                      "hamming", "id", "inverted", "mirrored", "opencv4",
                                      "quiet_zone", "turned_deg"}));
  EXPECT_EQ(candidates[0]["family"], "tag36h9");
  EXPECT_EQ(candidates[1]["family"], "tag36h9x");
  EXPECT_EQ(candidates[0]["id"], 12);
  EXPECT_EQ(candidates[0]["border"], "cut");
  EXPECT_EQ(candidates[0]["quiet_zone"], false);
  EXPECT_EQ(candidates[0]["mirrored"], false);
  EXPECT_EQ(candidates[0]["turned_deg"], 0.0);
  EXPECT_TRUE(candidates[0]["opencv4"].is_null());
  EXPECT_EQ(candidates[0]["corners"].size(), 4u);
}

TEST(IdentifyProgram, ReadsPicturesOfOnePixelACellWithTransparency) {
  const ScratchFolder folder;
  for (const std::string name : {"tagCircle21h7", "tagCustom48h12"}) {
    ASSERT_EQ(tagmint({"convert", name, "--codes", "3", "--to", "png", "-o", folder.file(name)})
                  .exit_code,
              0);
    int pictures = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.file(name))) {
      const std::string file = entry.path().string();
      const ProgramResult result = tagmint({"identify", file, "--format", "json"});
      ASSERT_EQ(result.exit_code, 0) << file << result.err;
      const Json found = Json::parse(result.out);
      EXPECT_EQ(found["tags"].size(), file.ends_with("mosaic.png") ? 3u : 1u) << file;
      EXPECT_EQ(found["tags"][0]["candidates"][0]["family"], name);
      ++pictures;
    }
    EXPECT_EQ(pictures, 4);
  }
}

TEST(IdentifyProgram, LooksForTheUsersFamilyOfAnyKind) {
  const ScratchFolder folder;
  ASSERT_EQ(
      tagmint({"generate", "--layout", "classic:9", "--min-hamming", "7", "--order", "seed:9",
               "--limit-codes", "20", "--name", "mine", "-o", folder.file("mine.json"), "--quiet"})
          .exit_code,
      0);
  ASSERT_EQ(tagmint({"convert", folder.file("mine.json"), "-o", folder.file("mine.yml"), "--quiet"})
                .exit_code,
            0);
  ASSERT_EQ(tagmint({"render", folder.file("mine.json"), "--ids", "19", "-o",
                     folder.file("scene.png"), "--quiet"})
                .exit_code,
            0);
  for (const char* kind : {"mine.json", "mine.yml"}) {
    const ProgramResult result =
        tagmint({"identify", folder.file("scene.png"), "--family", folder.file(kind)});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("mine id 19\n"), std::string::npos) << result.out;
  }
  // Those alone: a tag of another family is no match then.
  const std::string other =
      saved(folder, "other.png", print_tag(*codec::find_family("tag25h9"), 3, {.cell_px = 9}));
  EXPECT_EQ(tagmint({"identify", other, "--family", folder.file("mine.json"), "--only"}).exit_code,
            1);
  EXPECT_EQ(tagmint({"identify", other, "--family", "tag25h9", "--only"}).exit_code, 0);
}

TEST(IdentifyProgram, TellsTheNearestMissWithExitCodeOne) {
  const ScratchFolder folder;
  const auto family = codec::find_family("tag36h11");
  const codec::Codeword wrong = 0b100010001000100010001;  // 6 bits; 5 are always corrected
  const std::string file = saved(
      folder, "a.png",
      print_word(family->layout(), family->codeword(3) ^ wrong, {.cell_px = 6, .quiet_cells = 1}));
  const ProgramResult text = tagmint({"identify", file, "--family", "tag36h11", "--only"});
  EXPECT_EQ(text.exit_code, 1);
  EXPECT_NE(text.out.find("no tag that could not be an accident\n"
                          "nearest: tag36h11 id 3, 6 of 36 cells differ; "),
            std::string::npos)
      << text.out;
  const Json found = Json::parse(
      tagmint({"identify", file, "--family", "tag36h11", "--only", "--format", "json"}).out);
  EXPECT_TRUE(found["tags"].empty());
  EXPECT_EQ(found["nearest"]["id"], 3);
  EXPECT_EQ(found["nearest"]["hamming"], 6);
}

TEST(IdentifyProgram, APictureWithoutATagIsNoMatch) {
  const ScratchFolder folder;
  const std::string file = saved(folder, "gray.png", detect::Image(50, 40, 128));
  const ProgramResult result = tagmint({"identify", file});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out,
            file + ": 50 x 40 px, no tag; nothing in it has cells and a border like one\n");
  EXPECT_EQ(result.err, "");
}

TEST(IdentifyProgram, RefusesWhatIsNoPictureAndWrongOptions) {
  const ScratchFolder folder;
  const std::string garbage = folder.file("garbage.png");
  std::ofstream(garbage) << "no picture at all";
  expect_fault(
      {"identify", garbage}, 3,
      "not an image of a known kind (" + garbage + "); give a PNG, JPEG, PNM or TIFF file");
  const std::string good = saved(folder, "a.png", detect::Image(20, 20, 128));
  expect_fault({"identify", good, "--only"}, 2,
               "there is no family to look for (--only); add --family FAMILY");
  expect_fault({"identify", good, "--family", "tag16h5", "--family", "tag16h5"}, 2,
               "the family tag16h5 is given twice (--family); give each once");
  EXPECT_EQ(tagmint({"identify", folder.file("missing.png")}).exit_code, 3);
  EXPECT_EQ(tagmint({"identify", good, "--family", "tag17h5"}).exit_code, 3);
  EXPECT_EQ(tagmint({"identify"}).exit_code, 2);
}

}  // namespace
}  // namespace tagmint::test
