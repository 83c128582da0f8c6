// Dictionaries that `tagmint convert` writes, loaded by OpenCV's aruco: it reads our printed sheet
// with the same ids and corners; and OpenCV's own dictionaries, read by tagmint.
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
#include "tagmint/codec/tag_cells.h"
#include "tagmint/detect/detector.h"

namespace tagmint {
namespace {

namespace aruco = cv::aruco;

std::string run(const std::vector<std::string>& words) {
  const test::ProgramResult result = test::tagmint(words);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return result.err;
}

cv::Ptr<aruco::Dictionary> load_dictionary(const std::string& file) {
  cv::FileStorage storage(file, cv::FileStorage::READ);
  EXPECT_TRUE(storage.isOpened()) << file;
  auto dictionary = cv::makePtr<aruco::Dictionary>();
  EXPECT_TRUE(dictionary->readDictionary(storage.root())) << file;
  return dictionary;
}

/// Row by row, '1' is white: marker `id` of a dictionary.
std::string bits_of(const aruco::Dictionary& dictionary, int id) {
  const cv::Mat bits =
      aruco::Dictionary::getBitsFromByteList(dictionary.bytesList.row(id), dictionary.markerSize);
  std::string text;
  for (const auto bit : cv::Mat_<unsigned char>(bits)) text += bit ? '1' : '0';
  return text;
}

/// Row by row, '1' is white: the data square of a classic tag.
std::string bits_of(const codec::Family& family, codec::TagId id) {
  const codec::TagCells cells = codec::tag_cells(family.layout(), family.codeword(id));
  std::string text;
  for (int y = 2; y < cells.width() - 2; ++y) {
    for (int x = 2; x < cells.width() - 2; ++x) {
      text += cells.at(x, y) == codec::Cell::White ? '1' : '0';
    }
  }
  return text;
}

/// By id the four corners, clockwise from the first one.
std::map<int, std::vector<cv::Point2f>> markers_in(const cv::Mat& picture,
                                                   const cv::Ptr<aruco::Dictionary>& dictionary) {
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  aruco::detectMarkers(picture, dictionary, corners, ids);
  std::map<int, std::vector<cv::Point2f>> markers;
  for (std::size_t i = 0; i < ids.size(); ++i) markers[ids[i]] = corners[i];
  return markers;
}

struct Dictionary {
  const char* title;
  const char* opencv;     ///< --opencv
  const char* extension;  ///< of the file
  const char* layout;     ///< of a new family
  const char* min_hamming;
};

class ExportedDictionary : public testing::TestWithParam<Dictionary> {};

TEST_P(ExportedDictionary, ReadsOurSheetWithTheSameIdsAndCorners) {
  const Dictionary& parameter = GetParam();
  const test::ScratchFolder folder;
  const std::string own = folder.file("own.json");
  const std::string file = folder.file(std::string("dictionary") + parameter.extension);
  run({"generate", "--layout", parameter.layout, "--min-hamming", parameter.min_hamming,
       "--limit-codes", "24", "--name", "own", "-o", own});
  run({"convert", own, "--to", "opencv", "--opencv", parameter.opencv, "-o", file});
  run({"sheet", own, "--ids", "0-11", "--edge", "25mm", "--dpi", "150", "-o",
       folder.file("sheet.png")});
  const cv::Mat picture = cv::imread(folder.file("sheet.png"), cv::IMREAD_GRAYSCALE);
  ASSERT_FALSE(picture.empty());

  const codec::SharedFamily family = codec::load_family(own);
  const cv::Ptr<aruco::Dictionary> dictionary = load_dictionary(file);
  EXPECT_EQ(dictionary->maxCorrectionBits, (family->min_hamming() - 1) / 2);
  ASSERT_EQ(dictionary->bytesList.rows, static_cast<int>(family->size()));
  const auto theirs = markers_in(picture, dictionary);
  EXPECT_EQ(theirs.size(), 12U);

  detect::Detector detector({std::make_shared<const codec::Decoder>(family)});
  std::map<int, detect::Corners> ours;
  for (const detect::Detection& tag : detector.detect(
           {picture.data, picture.cols, picture.rows, static_cast<std::ptrdiff_t>(picture.step)})) {
    ours[static_cast<int>(tag.id)] = tag.corners;
  }
  EXPECT_EQ(ours.size(), 12U);
  // Ours are 0 bottom left, 1 bottom right, 2 top right, 3 top left. OpenCV goes clockwise from the
  // top left corner of the marker as the dictionary has it: of a marker that is turned by 180
  // degrees, the bottom right one.
  const bool turned = parameter.opencv == std::string("4");
  const std::array<int, 4> ours_of_theirs =
      turned ? std::array{1, 0, 3, 2} : std::array{3, 2, 1, 0};
  for (const auto& [id, corners] : theirs) {
    ASSERT_TRUE(ours.contains(id)) << "only OpenCV sees id " << id;
    for (int k = 0; k < 4; ++k) {
      const detect::Point our_corner = ours[id][ours_of_theirs[k]];
      // OpenCV's corners without refinement are whole pixels of a contour inside the black edge.
      EXPECT_NEAR(corners[k].x + 0.5, our_corner.x, 1.5) << "id " << id << " corner " << k;
      EXPECT_NEAR(corners[k].y + 0.5, our_corner.y, 1.5) << "id " << id << " corner " << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, ExportedDictionary,
    testing::Values(Dictionary{"Yaml4", "4", ".yml", "classic:9", "8"},
                    Dictionary{"Yaml5", "5", ".yaml", "classic:9", "8"},
                    Dictionary{"Json4", "4", ".json", "classic:8", "5"},
                    Dictionary{"Json5", "5", ".json", "classic:10", "11"},
                    Dictionary{"PackedYaml4", "4", ".yml.gz", "classic:11", "18"},
                    Dictionary{"PackedJson5", "5", ".json.gz", "classic:12", "24"}),
    [](const auto& info) { return std::string(info.param.title); });

struct OwnDictionary {
  const char* family;
  aruco::PREDEFINED_DICTIONARY_NAME name;
};

TEST(ExportedDictionary, OfAprilTagFamiliesIsOpenCvsOwn) {
  for (const OwnDictionary& own : {OwnDictionary{"tag16h5", aruco::DICT_APRILTAG_16h5},
                                   {"tag25h9", aruco::DICT_APRILTAG_25h9},
                                   {"tag36h10", aruco::DICT_APRILTAG_36h10},
                                   {"tag36h11", aruco::DICT_APRILTAG_36h11}}) {
    const test::ScratchFolder folder;
    run({"convert", own.family, "--opencv", "4", "-o", folder.file("own.yml")});
    const auto ours = load_dictionary(folder.file("own.yml"));
    const auto theirs = aruco::getPredefinedDictionary(own.name);
    EXPECT_EQ(ours->markerSize, theirs->markerSize);
    ASSERT_EQ(ours->bytesList.rows, theirs->bytesList.rows) << own.family;
    EXPECT_EQ(cv::norm(ours->bytesList, theirs->bytesList, cv::NORM_INF), 0) << own.family;
  }
}

TEST(ImportedDictionary, AprilTagDictionariesAreRecognisedAndTurnedUpright) {
  for (const char* extension : {".yml", ".json", ".yml.gz", ".json.gz"}) {
    const test::ScratchFolder folder;
    const std::string file = folder.file(std::string("theirs") + extension);
    auto storage = cv::makePtr<cv::FileStorage>(file, cv::FileStorage::WRITE);
    aruco::getPredefinedDictionary(aruco::DICT_APRILTAG_36h11)->writeDictionary(storage);
    storage->release();
    const std::string told = run({"convert", file, "-o", folder.file("back.json")});
    EXPECT_NE(told.find("this is tag36h11 as OpenCV 4 has it"), std::string::npos) << told;
    const codec::SharedFamily back = codec::load_family(folder.file("back.json"));
    const codec::SharedFamily tag36h11 = codec::find_family("tag36h11");
    EXPECT_EQ(back->name(), "tag36h11");
    EXPECT_EQ(back->min_hamming(), 11);
    EXPECT_TRUE(std::ranges::equal(back->codewords(), tag36h11->codewords()));
  }
}

TEST(OlderSystem, ArucoOriginalIsOpenCvsDictionary) {
  const test::ScratchFolder folder;
  run({"convert", "aruco-original", "-o", folder.file("ours.json")});
  const codec::SharedFamily ours = codec::load_family(folder.file("ours.json"));
  const auto theirs = aruco::getPredefinedDictionary(aruco::DICT_ARUCO_ORIGINAL);
  ASSERT_EQ(static_cast<int>(ours->size()), theirs->bytesList.rows);
  for (int id = 0; id < theirs->bytesList.rows; ++id) {
    EXPECT_EQ(bits_of(*ours, static_cast<codec::TagId>(id)), bits_of(*theirs, id)) << id;
  }
}

struct Predefined {
  aruco::PREDEFINED_DICTIONARY_NAME name;
  int codes;
  int min_hamming;  ///< true distance over all rotations; 0 = some tag equals a turn of another
};

TEST(ImportedDictionary, ArucoDictionariesKeepTheirIdsAndLooksAndGetTheirTrueDistance) {
  for (const Predefined& predefined : {Predefined{aruco::DICT_4X4_50, 50, 4},
                                       {aruco::DICT_4X4_100, 100, 3},
                                       {aruco::DICT_4X4_1000, 1000, 2},
                                       {aruco::DICT_5X5_50, 50, 8},
                                       {aruco::DICT_6X6_250, 250, 11},
                                       {aruco::DICT_7X7_1000, 1000, 14},
                                       {aruco::DICT_ARUCO_ORIGINAL, 1024, 0}}) {
    const test::ScratchFolder folder;
    const std::string file = folder.file("theirs.yml");
    auto storage = cv::makePtr<cv::FileStorage>(file, cv::FileStorage::WRITE);
    const auto theirs = aruco::getPredefinedDictionary(predefined.name);
    theirs->writeDictionary(storage);
    storage->release();
    const std::string told = run({"convert", file, "-o", folder.file("back.json")});
    const codec::SharedFamily back = codec::load_family(folder.file("back.json"));
    ASSERT_EQ(static_cast<int>(back->size()), predefined.codes);
    EXPECT_EQ(back->min_hamming(), std::max(1, predefined.min_hamming));
    const bool ambiguous = told.find("is equal to a turn of") != std::string::npos;
    EXPECT_EQ(ambiguous, predefined.min_hamming == 0) << told;
    for (int id = 0; id < predefined.codes; ++id) {
      EXPECT_EQ(bits_of(*back, static_cast<codec::TagId>(id)), bits_of(*theirs, id)) << id;
    }
  }
}

}  // namespace
}  // namespace tagmint
