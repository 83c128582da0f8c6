#include <fmt/format.h>

#include <algorithm>

#include "detector/drawn_scene.h"
#include "detector/picture_set.h"
#include "detector/scattered_sets.h"

namespace tagmint::bench {
namespace {

using scene::RandomSceneOptions;

const std::string kFamily = "tag36h11";

/// Seen from the front, px; tilted by up to 50 degrees they look as small as 8 px.
constexpr double kCrowdedSide_px = 10;

/// A set of grids of tags of one side.
PictureSet grid_set(std::string name, std::string about, double side_px, int quiet_zone_cells,
                    const scene::Effects& effects, const PictureSize& size) {
  PictureSet set{.name = std::move(name), .about = std::move(about)};
  set.draw = [side_px, quiet_zone_cells, effects, size](int index, std::uint64_t seed) {
    scene::Scene scene = grid_scene(side_px, quiet_zone_cells, size, picture_seed(seed, index));
    scene.effects = effects;
    return picture_of(scene);
  };
  return set;
}

void add_usual_sets(const PictureSize& size, std::vector<PictureSet>& sets) {
  sets.push_back(random_set("crowded", "54 tags of 8 to 100 px on clutter, noise 5, blur 0.7 px",
                            scattered(size, 54, kCrowdedSide_px, 100)));
  RandomSceneOptions sparse = scattered(size, 4, 60, 150);
  sparse.background = scene::GradientBackground{};
  sparse.effects = camera_effects(0.5);
  sets.push_back(random_set("sparse", "4 tags of 60 to 150 px on a gradient, noise 0.5", sparse));
  RandomSceneOptions flat = scattered(size, 6, 30, 100);
  flat.background = scene::PlainBackground{128};
  sets.push_back(random_set("flat", "6 tags of 30 to 100 px on plain gray, noise 5", flat));
}

void add_sets_by_size(const PictureSize& size, std::vector<PictureSet>& sets) {
  for (const int side : {8, 9, 10, 11, 12, 13, 15, 18, 23, 30}) {
    sets.push_back(grid_set(
        fmt::format("small-{}", side),
        fmt::format("tags of {} px from the front, white ring of one cell, noise 5, blur 0.5 px",
                    side),
        side, 0, camera_effects(5, 0.5), size));
  }
  for (const int side : {10, 11, 12, 15, 18, 24, 32, 48, 70, 100}) {
    sets.push_back(grid_set(fmt::format("distance-{}", side),
                            fmt::format("tags of {} px from the front, noise 2, blur 0.7 px", side),
                            side, 1, camera_effects(2), size));
  }
}

void add_sets_of_noise(const PictureSize& size, std::vector<PictureSet>& sets) {
  for (const int noise : {0, 5, 10, 20, 40}) {
    RandomSceneOptions options = scattered(size, 30, 40, 100);
    options.effects = camera_effects(noise);
    sets.push_back(random_set(fmt::format("noise-{}", noise),
                              fmt::format("30 tags of 40 to 100 px on clutter, noise {}", noise),
                              options));
  }
  RandomSceneOptions faint = scattered(size, 30, 40, 100);
  faint.background = scene::PlainBackground{124};
  faint.effects = camera_effects(1);
  faint.effects.black = 120;
  faint.effects.white = 128;
  sets.push_back(
      random_set("faint", "30 tags of 40 to 100 px, 8 gray levels of contrast, noise 1", faint));
}

void add_sets_of_cost(const PictureSize& size, std::vector<PictureSet>& sets) {
  const std::vector<std::string> three = {kFamily, "tag25h9", "tagStandard41h12"};
  RandomSceneOptions options = scattered(size, 54, 20, 100);
  for (const std::size_t count : {std::size_t{1}, three.size()}) {
    // The same pictures; a search for one family finds its third of the tags.
    PictureSet set{.name = fmt::format("families-{}", count),
                   .about = fmt::format("54 tags of three families, {} looked for", count)};
    set.task.families.assign(three.begin(), three.begin() + static_cast<std::ptrdiff_t>(count));
    set.draw = [options, three, wanted = set.task.families](int index, std::uint64_t seed) {
      RandomSceneOptions own = options;
      own.seed = picture_seed(seed, index);
      Picture picture = picture_of(scene::random_scene(choices_of(three), own));
      std::erase_if(picture.tags, [&](const TrueTag& tag) {
        return std::find(wanted.begin(), wanted.end(), tag.family) == wanted.end();
      });
      return picture;
    };
    sets.push_back(std::move(set));
  }
  const PictureSize large{.width = 4000, .height = 3000};
  RandomSceneOptions many = scattered(large, 300, 12, 150);
  many.background = scene::ClutterBackground{.shapes = 4000};
  for (const int threads : {1, 2}) {
    sets.push_back(random_set(
        fmt::format("threads-{}", threads),
        fmt::format("4000 x 3000 px, 300 tags of 12 to 150 px on clutter, {} threads", threads),
        many, {.families = {kFamily}, .threads = threads}));
    sets.back().most = 2;
  }
}

}  // namespace

std::vector<PictureSet> rendered_sets(const PictureSize& size) {
  std::vector<PictureSet> sets;
  add_usual_sets(size, sets);
  add_sets_by_size(size, sets);
  add_sets_of_noise(size, sets);
  for (PictureSet& set : hard_sets(size)) sets.push_back(std::move(set));
  add_sets_of_cost(size, sets);
  return sets;
}

}  // namespace tagmint::bench
