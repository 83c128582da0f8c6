// The parts of `evaluate`: tables, points on disk, threads, scenes and judging.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "evaluate/experiment.h"
#include "evaluate/points_store.h"
#include "evaluate/scenes.h"
#include "evaluate/sighting.h"
#include "scene/projection.h"
#include "support/scratch_folder.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/errors.h"

namespace tagmint::evaluate {
namespace {

using test::ScratchFolder;

const Rows kRows = {{std::int64_t{3}, 0.1, std::string("a, \"b\""), Cell()},
                    {std::int64_t{-1}, 1e-9, std::string("c"), 5.0}};

TEST(EvaluateTable, CsvExplainsItsColumnsAndQuotesWords) {
  const Table table{.columns = {{"n", "a count"}, {"x_m", "metres"}, {"who", "name"}, {"y", "-"}},
                    .rows = kRows};
  EXPECT_EQ(format_csv(table, {"head"}),
            "# head\n# Columns:\n#   n    a count\n#   x_m  metres\n#   who  name\n#   y    -\n"
            "n,x_m,who,y\n3,0.1,\"a, \"\"b\"\"\",\n-1,1e-09,c,5\n");
  EXPECT_EQ(table.number(kRows[0], "x_m"), 0.1);
  EXPECT_EQ(table.number(kRows[0], "y"), std::nullopt);
  EXPECT_THROW(table.column("z"), std::logic_error);
}

TEST(EvaluateTable, RowsSurviveJson) {
  EXPECT_EQ(rows_from_json(nlohmann::json::parse(rows_to_json(kRows).dump())), kRows);
}

TEST(PointsStore, KeepsWhatWasPutAndForgetsHalfALine) {
  const ScratchFolder folder;
  const std::string path = folder.file("x.points");
  const nlohmann::json run = {{"seed", 1}};
  {
    PointsStore store(path, run, false);
    store.put("first", kRows);
    store.put("second", {});
  }
  {
    std::ofstream file(path, std::ios::app);
    file << "{\"point\":\"third\",\"ro";
  }
  {
    PointsStore store(path, run, false);
    EXPECT_EQ(store.known().size(), 2U);
    EXPECT_EQ(store.known().at("first"), kRows);
    store.put("third", kRows);
  }
  PointsStore store(path, run, false);
  EXPECT_EQ(store.known().size(), 3U);
  EXPECT_EQ(store.known().at("third"), kRows);
  store.remove();
  EXPECT_TRUE(folder.names().empty());
}

TEST(PointsStore, RefusesPointsOfAnotherRunUnlessItRestarts) {
  const ScratchFolder folder;
  const std::string path = folder.file("x.points");
  PointsStore(path, {{"seed", 1}}, false).put("first", kRows);
  EXPECT_THROW(PointsStore(path, {{"seed", 2}}, false), codec::InputError);
  EXPECT_TRUE(PointsStore(path, {{"seed", 2}}, true).known().empty());
}

TEST(EvaluateWork, EachIndexOnceAndTheFirstFaultIsThrown) {
  const Work work(3, {}, {});
  std::vector<int> seen(100);
  work.for_each(100, [&](int index, int thread) {
    EXPECT_LT(thread, 3);
    ++seen[static_cast<std::size_t>(index)];
  });
  EXPECT_EQ(seen, std::vector<int>(100, 1));
  EXPECT_THROW(work.for_each(5, [](int, int) { throw std::range_error("x"); }), std::range_error);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(Work(2, source.get_token(), {}).for_each(5, [](int, int) {}), Stopped);
}

TEST(EvaluateScenes, FrontalTagsAreAtTheirDistanceAndWholeInThePicture) {
  const codec::SharedFamily family = codec::find_family("tag36h11");
  for (const double distance : {0.5, 1.0, 3.0, 10.0}) {
    for (int picture = 0; picture < 20; ++picture) {
      const scene::Scene scene = frontal_scene(family, distance, 4, picture_seed(1, 2, picture));
      ASSERT_FALSE(scene.tags.empty()) << distance;
      for (const scene::SceneTag& tag : scene.tags) {
        const auto& posed = std::get<scene::PosedTag>(tag.place);
        const auto& t = posed.pose.t;
        EXPECT_NEAR(std::hypot(t[0], t[1], t[2]), distance, 1e-9);
        EXPECT_EQ(posed.pose.R[8], 1);
        for (const detect::Point p : scene::TagProjection(tag, scene.camera).corners()) {
          EXPECT_TRUE(p.x > 0 && p.y > 0 && p.x < kWidth_px && p.y < kHeight_px);
        }
      }
    }
  }
}

TEST(EvaluateScenes, TiltedTagsHaveTheirAngle) {
  for (const double angle : {0.0, 30.0, 85.0}) {
    const scene::Scene scene = tilted_scene(codec::find_family("tag36h11"), 2, angle, 7);
    const auto& pose = std::get<scene::PosedTag>(scene.tags[0].place).pose;
    EXPECT_NEAR(std::acos(pose.R[8]) * 180 / M_PI, angle, 1e-6);
    EXPECT_EQ(pose.t, (std::array<double, 3>{0, 0, 2}));
  }
}

TEST(EvaluateJudge, RightTagsCountAndOthersAreWrong) {
  const scene::Scene scene = frontal_scene(codec::find_family("tag36h11"), 2, 3, 5);
  ASSERT_GE(scene.tags.size(), 2U);
  const auto truth = scene::render(scene).truth;
  std::vector<FoundTag> reports(3);
  for (std::size_t i = 0; i < 2; ++i) {
    reports[i].id = scene.tags[i].id;
    reports[i].corners = truth[i].corners;
  }
  for (detect::Point& p : reports[1].corners) p = p + detect::Point{3, 4};
  reports[2] = reports[0];  // the same tag again
  const View view = judge(reports, scene, truth);
  ASSERT_EQ(view.tags.size(), scene.tags.size());
  EXPECT_TRUE(view.tags[0].found);
  EXPECT_NEAR(*view.tags[0].distance_error_m, 0, 1e-6);
  EXPECT_NEAR(*view.tags[0].orientation_error_deg, 0, 1e-3);
  EXPECT_NEAR(view.tags[1].corner_error_px, 5, 1e-12);
  EXPECT_EQ(view.wrong, 1);
  Tally tally;
  tally.add(view);
  EXPECT_EQ(tally.found, 2);
  EXPECT_EQ(tally.tags, static_cast<int>(scene.tags.size()));
}

TEST(EvaluateJudge, Quantiles) {
  EXPECT_EQ(quantile({}, 0.5), std::nullopt);
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1}), 2.5);
  EXPECT_EQ(quantile({1, 2, 3, 4, 5}, 1), 5);
}

}  // namespace
}  // namespace tagmint::evaluate
