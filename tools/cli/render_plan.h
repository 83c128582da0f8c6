#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/random_scene.h"
#include "scene/scene.h"

namespace tagmint::cli {

/// The options of `tagmint render` as they were given.
struct RenderArguments {
  std::vector<std::string> inputs;  ///< one scene file, or families
  std::string ids;                  ///< those of the random scene's, "0-9,12"; empty = all
  std::string size = "640x480";
  int count = 0;  ///< 0 = as many as there are --ids, else what finds room of kDefaultCount
  std::string background = "texture";
  std::string motion_blur;  ///< "LENGTH" or "LENGTH,ANGLE", px and degrees; empty = none
  scene::RandomSceneOptions random;
  std::vector<std::string> random_options;  ///< names of the options given that a file excludes
  std::string truth;
  std::string format;
  std::string output;
};

inline constexpr int kDefaultCount = 8;

/// The scene to draw: read from the file, or made at random from the families and options.
/// Throws UsageError for options that do not fit, InputError for a file that cannot be read.
scene::Scene plan_scene(const RenderArguments& arguments);

/// What is behind the tags: `gray:LEVEL`, `gradient:FROM,TO`, `texture`, `texture:GRAY,AMPLITUDE`
/// (gray levels), `clutter`, `clutter:SHAPES`, or the path of a picture. Throws UsageError,
/// InputError.
scene::Background parse_background(const std::string& text);

}  // namespace tagmint::cli
