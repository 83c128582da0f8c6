#include "io/detections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/test_families.h"

namespace tagmint::io {
namespace {

using Json = nlohmann::json;

ImageResult result_of_two_tags() {
  ImageResult result{.image = "a \"b\",c.png",
                     .width = 640,
                     .height = 480,
                     .elapsed_ms = 1.93,
                     .tags = {},
                     .error = {}};
  FoundTag tag;
  tag.detection.family = test::arbitrary_family("classic:10");
  tag.detection.id = 7;
  tag.detection.hamming = 1;
  tag.detection.decision_margin = 61.25;
  tag.detection.center = {1234.567890123, 1.0 / 3};
  tag.detection.corners = {{{1, 2}, {30.000001, 4}, {5, 6}, {7, 1e-7}}};
  tag.detection.homography = detect::Homography({1, 2, 3, 4, 5, 6, 7, 8, 1});
  result.tags.push_back(tag);
  tag.pose.emplace();
  tag.pose->best.t = {0.1, 0.2, 0.3};
  tag.pose->best.error = 1e-9;
  tag.pose->alternative.emplace();
  tag.pose->alternative->R = {0, 1, 0, -1, 0, 0, 0, 0, 1};
  result.tags.push_back(tag);
  return result;
}

TEST(DetectionsJsonl, HasExactlyThePromisedKeys) {
  const std::string line = format_jsonl(result_of_two_tags());
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
  EXPECT_EQ(line.back(), '\n');
  const Json json = Json::parse(line);
  EXPECT_EQ(json.size(), 5U);
  EXPECT_EQ(json.at("image"), "a \"b\",c.png");
  EXPECT_EQ(json.at("width"), 640);
  EXPECT_EQ(json.at("height"), 480);
  EXPECT_EQ(json.at("elapsed_ms"), 1.93);
  ASSERT_EQ(json.at("detections").size(), 2U);
  const Json& plain = json.at("detections")[0];
  EXPECT_EQ(plain.size(), 9U);  // seven fields as libapriltag has them, two of our own
  EXPECT_EQ(plain.at("family"), "arbitrary");
  EXPECT_EQ(plain.at("id"), 7);
  EXPECT_EQ(plain.at("hamming"), 1);
  EXPECT_EQ(plain.at("decision_margin"), 61.25);
  EXPECT_EQ(plain.at("homography"), (Json{1, 2, 3, 4, 5, 6, 7, 8, 1}));
  const Json& posed = json.at("detections")[1];
  EXPECT_EQ(posed.size(), 11U);
  EXPECT_EQ(posed.at("pose").size(), 3U);
  EXPECT_EQ(posed.at("pose").at("R"), (Json{1, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(posed.at("pose").at("t"), (Json{0.1, 0.2, 0.3}));
  EXPECT_EQ(posed.at("pose").at("error"), 1e-9);
  EXPECT_EQ(posed.at("pose_alternative").at("R"), (Json{0, 1, 0, -1, 0, 0, 0, 0, 1}));
}

TEST(DetectionsJsonl, KeysStandInThePromisedOrder) {
  const auto json = nlohmann::ordered_json::parse(format_jsonl(result_of_two_tags()));
  const auto keys = [](const nlohmann::ordered_json& object) {
    std::vector<std::string> names;
    for (const auto& [name, value] : object.items()) names.push_back(name);
    return names;
  };
  EXPECT_EQ(keys(json),
            (std::vector<std::string>{"image", "width", "height", "elapsed_ms", "detections"}));
  EXPECT_EQ(keys(json["detections"][1]),
            (std::vector<std::string>{"family", "id", "hamming", "decision_margin", "center",
                                      "corners", "homography", "pose", "pose_alternative",
                                      "margin_to_noise", "log_odds"}));
}

TEST(DetectionsJsonl, SaysWhatIsKnownOfErrorsAndPrints) {
  ImageResult result = result_of_two_tags();
  FoundTag& tag = result.tags[1];
  tag.detection.margin_to_noise = 12.5;
  tag.detection.log_odds = 30.25;
  tag.detection.inverted = true;
  detect::CornerCovariance corners{};
  corners[0] = 0.0001234567;
  tag.detection.corner_covariance = corners;
  detect::PoseCovariance pose{};
  pose[35] = 2.5e-7;
  tag.pose->best.covariance = pose;
  tag.pose->best.chi_squared = 1.5;
  tag.pose->alternative_probability = 0.25;
  const Json json = Json::parse(format_jsonl(result)).at("detections")[1];
  EXPECT_EQ(json.at("margin_to_noise"), 12.5);
  EXPECT_EQ(json.at("log_odds"), 30.25);
  EXPECT_EQ(json.at("inverted"), true);
  EXPECT_FALSE(json.contains("mirrored"));
  EXPECT_EQ(json.at("corner_covariance").size(), 64U);
  EXPECT_EQ(json.at("corner_covariance")[0], 0.000123457);
  EXPECT_EQ(json.at("pose").at("covariance").size(), 36U);
  EXPECT_EQ(json.at("pose").at("covariance")[35], 2.5e-7);
  EXPECT_EQ(json.at("pose").at("chi_squared"), 1.5);
  EXPECT_FALSE(json.at("pose_alternative").contains("covariance"));
  EXPECT_EQ(json.at("pose_alternative_probability"), 0.25);
  EXPECT_EQ(json.at("pose_ambiguous"), true);
}

TEST(DetectionsJsonl, CoordinatesComeBackToAMillionthOfAPixel) {
  const ImageResult result = result_of_two_tags();
  const Json tag = Json::parse(format_jsonl(result)).at("detections")[0];
  EXPECT_NEAR(tag.at("center")[0].get<double>(), result.tags[0].detection.center.x, 1e-6);
  EXPECT_NEAR(tag.at("center")[1].get<double>(), 1.0 / 3, 1e-6);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(tag.at("corners")[i][0].get<double>(), result.tags[0].detection.corners[i].x, 1e-6);
    EXPECT_NEAR(tag.at("corners")[i][1].get<double>(), result.tags[0].detection.corners[i].y, 1e-6);
  }
}

TEST(DetectionsJsonl, OfAnUnreadableImageHoldsItsNameAndTheReason) {
  ImageResult result;
  result.image = "bad.png";
  result.error = "cut short \\ \"here\"";
  EXPECT_EQ(Json::parse(format_jsonl(result)),
            (Json{{"image", "bad.png"}, {"error", "cut short \\ \"here\""}}));
}

TEST(DetectionsJsonl, StaysJsonForFileNamesThatAreNotUtf8) {
  ImageResult result;
  result.image = "caf\xe9.png";
  EXPECT_TRUE(Json::parse(format_jsonl(result)).contains("image"));
}

TEST(DetectionsCsv, HasAsManyFieldsAsItsHeader) {
  const auto fields = [](const std::string& line) {
    bool quoted = false;
    int commas = 0;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      commas += c == ',' && !quoted;
    }
    return commas + 1;
  };
  for (const bool poses : {false, true}) {
    const std::string text = csv_header(poses) + format_csv(result_of_two_tags(), poses);
    const int expected = fields(csv_header(poses));
    EXPECT_EQ(expected, poses ? 50 : 24);
    std::size_t begin = 0;
    int lines = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos;
         end = text.find('\n', begin)) {
      EXPECT_EQ(fields(text.substr(begin, end - begin)), expected);
      begin = end + 1;
      ++lines;
    }
    EXPECT_EQ(lines, 3);
  }
  EXPECT_TRUE(format_csv(result_of_two_tags(), false)
                  .starts_with("\"a \"\"b\"\",c.png\",arbitrary,7,1,61.25,1234.56789012,"));
}

TEST(DetectionsText, AlignsItsColumns) {
  const std::string text = format_text(result_of_two_tags());
  EXPECT_TRUE(text.starts_with("a \"b\",c.png: 640 x 480 px, 2 tags, 1.93 ms\n")) << text;
  EXPECT_NE(text.find("0.1000    0.2000    0.3000\n"), std::string::npos) << text;
  ImageResult none;
  none.image = "b.png";
  none.width = none.height = 9;
  EXPECT_EQ(format_text(none), "b.png: 9 x 9 px, 0 tags, 0.00 ms\n");
}

}  // namespace
}  // namespace tagmint::io
