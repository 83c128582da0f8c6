#include "scene/scene_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "io/images.h"
#include "support/places.h"
#include "support/scratch_folder.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::scene {
namespace {

Scene parse(const std::string& json) { return parse_scene(json, "test.json", "."); }

/// Expects InputError with exactly this text.
void expect_fault(const std::string& json, const std::string& message) {
  try {
    parse(json);
    ADD_FAILURE() << "read: " << json;
  } catch (const codec::InputError& fault) {
    EXPECT_EQ(fault.what(), message) << json;
  }
}

/// A scene of one tag with the given members.
std::string with_tag(const std::string& members) {
  return R"({"width":64,"height":48,"tags":[{)" + members + "}]}";
}

TEST(SceneFile, ReadsEveryKey) {
  const Scene scene = parse(R"({
    "width": 320, "height": 200,
    "camera": {"fx": 300, "fy": 310, "cx": 161, "cy": 99, "distortion": [0.1, 0.2, 0.003, 0.004, 0.5]},
    "background": {"gradient": {"from": 10, "to": 90, "angle_deg": 45}},
    "quiet_zone_cells": 2,
    "tags": [
      {"family": "tag36h11", "id": 7, "edge_m": 0.05, "position_m": [0, 0.1, 2], "rotation_deg": [0, 0, 90]},
      {"family": "tag36h11", "id": 8, "edge_m": 0.06,
       "pose": {"R": [1, 0, 0, 0, 1, 0, 0, 0, 1], "t": [0, 0, 3]}},
      {"family": "tag16h5", "id": 3, "corners": [[10, 60], [60, 62], [58, 12], [12, 10]]}],
    "black": 20, "white": 200, "shading": {"strength": 0.25, "angle_deg": 90},
    "blur_px": 0.8, "noise": 3, "seed": 18446744073709551615})");
  EXPECT_EQ(scene.width, 320);
  EXPECT_EQ(scene.height, 200);
  EXPECT_EQ(scene.camera.fy, 310);
  EXPECT_EQ(scene.camera.cx, 161);
  EXPECT_EQ(scene.camera.p1, 0.003);
  EXPECT_EQ(scene.camera.k3, 0.5);
  EXPECT_EQ(std::get<GradientBackground>(scene.background).to, 90);
  EXPECT_EQ(scene.quiet_zone_cells, 2);
  ASSERT_EQ(scene.tags.size(), 3U);
  EXPECT_EQ(scene.tags[0].id, 7U);
  EXPECT_EQ(scene.tags[0].family, scene.tags[1].family);
  const auto& turned = std::get<PosedTag>(scene.tags[0].place);
  EXPECT_EQ(turned.edge_m, 0.05);
  EXPECT_NEAR(turned.pose.R[3], 1, 1e-15);
  EXPECT_EQ(turned.pose.t[1], 0.1);
  EXPECT_EQ(std::get<PosedTag>(scene.tags[1].place).pose.t[2], 3);
  EXPECT_EQ(std::get<detect::Corners>(scene.tags[2].place)[2], (detect::Point{58, 12}));
  EXPECT_EQ(scene.effects.black, 20);
  EXPECT_EQ(scene.effects.white, 200);
  EXPECT_EQ(scene.effects.shading.angle_deg, 90);
  EXPECT_EQ(scene.effects.blur_sigma_px, 0.8);
  EXPECT_EQ(scene.effects.noise_sigma, 3);
  EXPECT_EQ(scene.seed, 18446744073709551615ULL);
}

TEST(SceneFile, ReadsMarksLightAndTheCamerasEffects) {
  const Scene scene = parse(R"({
    "width": 320, "height": 200, "tags": [],
    "background": {"clutter": {"shapes": 70, "min_px": 5, "max_px": 90}},
    "marks": [{"path": [[1, 2], [3, 4]], "width_px": 1.5, "gray": 60}, {"path": [[5, 6]]}],
    "shadows": [{"polygon": [[0, 0], [90, 0], [0, 90]], "light": 0.4}],
    "glare": [{"center": [30, 40], "radius_px": 20, "strength": 150}],
    "vignetting": 0.3, "motion_blur": {"length_px": 6, "angle_deg": 30}, "gamma": 2.2,
    "defocus_px": 1.5, "electrons_per_level": 40, "jpeg_quality": 75})");
  EXPECT_EQ(std::get<ClutterBackground>(scene.background).shapes, 70);
  EXPECT_EQ(std::get<ClutterBackground>(scene.background).min_px, 5);
  EXPECT_EQ(std::get<ClutterBackground>(scene.background).max_px, 90);
  ASSERT_EQ(scene.marks.size(), 2U);
  EXPECT_EQ(scene.marks[0].path[1], (detect::Point{3, 4}));
  EXPECT_EQ(scene.marks[0].width_px, 1.5);
  EXPECT_EQ(scene.marks[0].gray, 60);
  EXPECT_EQ(scene.marks[1].width_px, 2);
  ASSERT_EQ(scene.effects.shadows.size(), 1U);
  EXPECT_EQ(scene.effects.shadows[0].polygon[2], (detect::Point{0, 90}));
  EXPECT_EQ(scene.effects.shadows[0].light, 0.4);
  ASSERT_EQ(scene.effects.glare.size(), 1U);
  EXPECT_EQ(scene.effects.glare[0].centre, (detect::Point{30, 40}));
  EXPECT_EQ(scene.effects.glare[0].radius_px, 20);
  EXPECT_EQ(scene.effects.glare[0].strength, 150);
  EXPECT_EQ(scene.effects.vignetting, 0.3);
  EXPECT_EQ(scene.effects.motion_blur.length_px, 6);
  EXPECT_EQ(scene.effects.motion_blur.angle_deg, 30);
  EXPECT_EQ(scene.effects.gamma, 2.2);
  EXPECT_EQ(scene.effects.defocus_px, 1.5);
  EXPECT_EQ(scene.effects.electrons_per_level, 40);
  EXPECT_EQ(scene.effects.jpeg_quality, 75);
}

TEST(SceneFile, LeavesDefaultsWhereNothingIsSaid) {
  const Scene scene = parse(R"({"width":640,"height":480,"tags":[]})");
  EXPECT_EQ(scene.camera.fx, 640);
  EXPECT_EQ(scene.camera.cy, 240);
  EXPECT_EQ(std::get<PlainBackground>(scene.background).gray, 128);
  EXPECT_EQ(scene.quiet_zone_cells, 1);
  EXPECT_EQ(scene.effects.noise_sigma, 0);
}

TEST(SceneFile, NamesThePlaceOfEveryFault) {
  expect_fault("{\n\"width\": 3,,\n}",
               "not valid JSON (test.json:2); look for a missing comma, quote or bracket there");
  expect_fault("[]",
               "the scene is not an object (test.json); write {...} with the keys width, height, "
               "camera, background, quiet_zone_cells, boards, tags, marks, black, white, shading, "
               "shadows, glare, vignetting, motion_blur, defocus_px, blur_px, "
               "electrons_per_level, gamma, noise, jpeg_quality, seed");
  expect_fault(R"({"width":1,"width":2,"height":3,"tags":[]})",
               "the key 'width' is given twice (test.json); keep one of them");
  expect_fault(R"({"width":9,"heigth":3,"tags":[]})",
               "the scene has an unknown key 'heigth' (test.json); did you mean 'height'?");
  expect_fault(R"({"width":9,"height":3})", "the scene lacks 'tags' (test.json); add it");
  expect_fault(R"({"width":9.5,"height":3,"tags":[]})",
               "width is 9.5 (test.json); it must be a whole number from 1 to 16384");
  expect_fault(R"({"width":9,"height":3,"tags":{}})",
               "tags is not a list (test.json); write [...]");
  expect_fault(R"({"width":9,"height":3,"tags":[],"noise":-1})",
               "noise is -1 (test.json); it must be from 0 to 255");
  expect_fault(R"({"width":9,"height":3,"tags":[],"noise":"2"})",
               "noise is not a number (test.json); write one without quotes");
  expect_fault(R"({"width":9,"height":3,"tags":[],"background":{}})",
               "background does not name one kind (test.json); give exactly one");
  expect_fault(R"({"width":9,"height":3,"tags":[],"camera":{"fx":0}})",
               "camera.fx is 0 (test.json); it must be from 0.001 to 1000000000");
  expect_fault(R"({"width":9,"height":3,"tags":[],"black":100,"white":90})",
               "black is 100 and white 90; black must be the darker one (test.json)");
}

TEST(SceneFile, NamesTheMarkOrTheLightAtFault) {
  const auto with = [](const std::string& member) {
    return R"({"width":9,"height":3,"tags":[],)" + member + "}";
  };
  expect_fault(with(R"("marks":[{"path":[]}])"),
               "marks[0]: its path has no point; give one or more (test.json)");
  expect_fault(with(R"("marks":[{"path":[[1,2,3]]}])"),
               "marks[0].path[0] has 3 numbers (test.json); give 2 of them");
  expect_fault(with(R"("shadows":[{"polygon":[[1,2],[3,4]]}])"),
               "shadows[0]: its polygon has fewer than three corners; give three or more "
               "(test.json)");
  expect_fault(with(R"("shadows":[{"light":2}])"),
               "shadows[0] lacks 'polygon' (test.json); add it");
  expect_fault(with(R"("glare":[{"center":[1,2],"radius_pix":3}])"),
               "glare[0] has an unknown key 'radius_pix' (test.json); did you mean 'radius_px'?");
  expect_fault(with(R"("motion_blur":{"length_px":-1})"),
               "motion_blur.length_px is -1 (test.json); it must be from 0 to 1000");
  expect_fault(with(R"("defocus_px":101)"),
               "defocus_px is 101 (test.json); it must be from 0 to 100");
  expect_fault(with(R"("electrons_per_level":0)"),
               "electrons_per_level is 0 (test.json); it must be from 0.001 to 1000000");
  expect_fault(with(R"("jpeg_quality":0)"),
               "jpeg_quality is 0 (test.json); it must be a whole number from 1 to 100");
  expect_fault(with(R"("gamma":0)"), "gamma is 0 (test.json); it must be from 0.1 to 10");
  expect_fault(with(R"("background":{"clutter":{"min_px":9,"max_px":8}})"),
               "background.clutter.max_px is 8; it must be from 9 to 1000000 (test.json)");
}

TEST(SceneFile, NamesTheTagAtFault) {
  expect_fault(with_tag(R"("family":7,"id":0)"),
               "tags[0].family is not a text (test.json); write it in double quotes");
  expect_fault(with_tag(R"("family":"tag16h5","id":30,"edge_m":1,"position_m":[0,0,1])"),
               "tags[0].id is 30 (test.json); it must be a whole number from 0 to 29");
  expect_fault(with_tag(R"("family":"tag16h5","id":3,"edge_m":1)"),
               "tags[0] lacks 'position_m' (test.json); add it");
  expect_fault(with_tag(R"("family":"tag16h5","id":3,"edge_m":1,"position_m":[0,1])"),
               "tags[0].position_m has 2 numbers (test.json); give 3 of them");
  expect_fault(with_tag(R"("family":"tag16h5","id":3,"edge_m":1,"corners":[])"),
               "tags[0] has corners and edge_m (test.json); place it one way or the other");
  expect_fault(with_tag(R"("family":"tag16h5","id":3,"corners":[[1,2]])"),
               "tags[0].corners are not four (test.json); give bottom-left, bottom-right, "
               "top-right, top-left");
  expect_fault(with_tag(R"("family":"tag16h5","id":3,"edge_m":1,"position_m":[0,0,-1])"),
               "tags[0]: its middle lies behind the camera (z = -1 m); z must be above 0 "
               "(test.json)");
  EXPECT_THROW(parse(with_tag(R"("family":"tag16h4","id":3)")), codec::InputError);
}

TEST(SceneFile, FindsFamiliesAndPicturesBesideItself) {
  const test::ScratchFolder folder;
  codec::write_family(*codec::find_family("tag16h5"), folder.file("mine.json"));
  detect::Image photo(8, 6, 77);
  io::write_png(folder.file("photo.png"), photo.view());
  test::write_file(folder.file("scene.json"),
                   R"({"width":8,"height":6,"background":{"image":"photo.png"},
                       "tags":[{"family":"mine.json","id":1,"edge_m":1,"position_m":[0,0,1e5]}]})");
  const Scene scene = read_scene(folder.file("scene.json"));
  EXPECT_EQ(scene.tags[0].family->name(), "tag16h5");
  EXPECT_EQ(std::get<PhotoBackground>(scene.background).image, photo);
  EXPECT_EQ(render(scene).image.at(0, 0), 77);
}

TEST(SceneFile, OfTheDocumentationIsAsItsPicture) {
  const std::string folder = (test::source_folder() / "docs" / "pictures").string() + "/";
  const detect::Image image = render(read_scene(folder + "scene.json")).image;
  const detect::Image shown = io::read_gray_image(folder + "scene.png");
  ASSERT_EQ(image.width(), shown.width());
  ASSERT_EQ(image.height(), shown.height());
  // The last digit of a logarithm may round another way on another machine.
  int different = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const int step = std::abs(image.at(x, y) - shown.at(x, y));
      ASSERT_LE(step, 1);
      different += step;
    }
  }
  EXPECT_LT(different, 50);
}

TEST(SceneFile, ThatIsMissingIsAnInputError) {
  EXPECT_THROW(read_scene("/nowhere/scene.json"), codec::InputError);
}

TEST(TruthFile, ComesBackAsItWas) {
  const Scene scene = parse(R"({"width":640,"height":480,"tags":[
    {"family":"tag36h11","id":7,"edge_m":0.1,"position_m":[0.01,0.02,0.7],"rotation_deg":[30,20,10]},
    {"family":"tag16h5","id":3,"corners":[[10,60],[60,62],[58,12],[12,10]]}]})");
  const Rendering rendering = render(scene);
  const auto truth = nlohmann::json::parse(format_truth(scene, rendering.truth));
  EXPECT_EQ(truth.at("width"), 640);
  EXPECT_EQ(truth.at("camera").at("fx"), 640);
  ASSERT_EQ(truth.at("tags").size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& tag = truth.at("tags")[i];
    EXPECT_EQ(tag.at("family"), scene.tags[i].family->name());
    EXPECT_EQ(tag.at("id"), scene.tags[i].id);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(tag.at("corners")[k][0], rendering.truth[i].corners[k].x);
      EXPECT_EQ(tag.at("corners")[k][1], rendering.truth[i].corners[k].y);
    }
    EXPECT_EQ(tag.at("homography").get<std::vector<double>>().size(), 9U);
    EXPECT_NEAR(tag.at("visible").get<double>(), 1, 1e-6);
    EXPECT_NEAR(tag.at("visible_px").get<double>(), rendering.truth[i].visible_px, 1e-3);
  }
  const auto& posed = std::get<PosedTag>(scene.tags[0].place);
  EXPECT_EQ(truth.at("tags")[0].at("edge_m"), 0.1);
  EXPECT_EQ((truth.at("tags")[0].at("pose").at("R").get<std::array<double, 9>>()), posed.pose.R);
  EXPECT_EQ((truth.at("tags")[0].at("pose").at("t").get<std::array<double, 3>>()), posed.pose.t);
  EXPECT_FALSE(truth.at("tags")[1].contains("pose"));
}

}  // namespace
}  // namespace tagmint::scene
