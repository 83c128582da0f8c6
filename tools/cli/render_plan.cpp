#include "cli/render_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "cli/camera_option.h"
#include "cli/command.h"
#include "cli/id_list.h"
#include "cli/options.h"
#include "io/images.h"
#include "scene/scene_file.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::cli {
namespace {

namespace fs = std::filesystem;

/// Whether `input` is a file, and not one of a family.
bool is_scene_file(const std::string& input) {
  std::error_code error;
  if (codec::find_family(input) || !fs::is_regular_file(input, error)) return false;
  std::ifstream file(input, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return text.find("\"tagmint-family\"") == std::string::npos;
}

/// "640x480" -> 640, 480.
std::pair<int, int> parse_size(const std::string& text) {
  int width = 0;
  int height = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, width);
  bool whole = first.ec == std::errc() && first.ptr != end && (*first.ptr == 'x');
  if (whole) {
    const auto second = std::from_chars(first.ptr + 1, end, height);
    whole = second.ec == std::errc() && second.ptr == end;
  }
  if (!whole || width < 1 || height < 1 || width > scene::kMaxSide_px ||
      height > scene::kMaxSide_px) {
    throw UsageError(
        fmt::format("'{}' is no image size", text), "--size",
        fmt::format("give WIDTHxHEIGHT in pixels, 1 to {} each, like 640x480", scene::kMaxSide_px));
  }
  return {width, height};
}

/// "6" or "6,30" -> 6 px along 0 or 30 degrees.
scene::MotionBlur parse_motion_blur(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t count = text.find(',') == std::string::npos ? 1 : 2;
  const auto numbers = parse_numbers(text, count, "--motion-blur", "LENGTH or LENGTH,ANGLE");
  return {.length_px = numbers[0], .angle_deg = count == 2 ? numbers[1] : 0};
}

std::vector<scene::TagChoice> choose_tags(const RenderArguments& arguments) {
  std::vector<scene::TagChoice> choices;
  for (const std::string& name : arguments.inputs) {
    scene::TagChoice choice{.family = codec::load_family(name), .ids = {}};
    if (!arguments.ids.empty()) choice.ids = parse_id_list(arguments.ids, choice.family->size());
    choices.push_back(std::move(choice));
  }
  return choices;
}

scene::Scene make_random_scene(const RenderArguments& arguments) {
  const std::vector<scene::TagChoice> choices = choose_tags(arguments);
  scene::RandomSceneOptions options = arguments.random;
  std::tie(options.width, options.height) = parse_size(arguments.size);
  options.background = parse_background(arguments.background);
  options.effects.motion_blur = parse_motion_blur(arguments.motion_blur);
  options.count = arguments.count;
  bool fewer_will_do = false;
  if (options.count == 0) {
    std::size_t listed = 0;
    for (const scene::TagChoice& choice : choices) listed += choice.ids.size();
    options.count = listed > 0 ? static_cast<int>(listed) : kDefaultCount;
    fewer_will_do = listed == 0;
  }
  scene::Scene made;
  try {
    made = scene::random_scene(choices, options);
  } catch (const std::invalid_argument& complaint) {
    throw usage_error(complaint, "render");
  }
  const std::size_t needed = fewer_will_do ? 1 : static_cast<std::size_t>(options.count);
  if (made.tags.size() < needed) {
    throw UsageError(fmt::format("only {} of {} tags found room", made.tags.size(), options.count),
                     arguments.size,
                     "ask for a smaller --count, smaller --min-side and --max-side or a larger "
                     "--size");
  }
  return made;
}

}  // namespace

scene::Background parse_background(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (kind == "gray" && !rest.empty()) {
    return scene::PlainBackground{parse_numbers(rest, 1, "--background", "gray:LEVEL")[0]};
  }
  if (kind == "gradient" && !rest.empty()) {
    const auto ends = parse_numbers(rest, 2, "--background", "gradient:FROM,TO");
    return scene::GradientBackground{.from = ends[0], .to = ends[1]};
  }
  if (text == "texture") return scene::TextureBackground{};
  if (kind == "texture" && !rest.empty()) {
    const auto levels = parse_numbers(rest, 2, "--background", "texture:GRAY,AMPLITUDE");
    return scene::TextureBackground{.gray = levels[0], .amplitude = levels[1]};
  }
  if (text == "clutter") return scene::ClutterBackground{};
  if (kind == "clutter" && !rest.empty()) {
    const double shapes = parse_numbers(rest, 1, "--background", "clutter:SHAPES")[0];
    if (shapes != std::floor(shapes) || shapes < 0 || shapes > scene::kMaxShapes) {
      throw UsageError(fmt::format("clutter of {} shapes cannot be", shapes), "--background",
                       fmt::format("give a whole number from 0 to {}", scene::kMaxShapes));
    }
    return scene::ClutterBackground{.shapes = static_cast<int>(shapes)};
  }
  std::error_code error;
  if (!fs::exists(text, error)) {
    throw UsageError(fmt::format("'{}' is neither a background nor a file", text), "--background",
                     "give gray:LEVEL, gradient:FROM,TO, texture, texture:GRAY,AMPLITUDE, clutter, "
                     "clutter:SHAPES or a picture");
  }
  return scene::PhotoBackground{text, io::read_gray_image(text)};
}

scene::Scene plan_scene(const RenderArguments& arguments) {
  const auto file = std::find_if(arguments.inputs.begin(), arguments.inputs.end(), is_scene_file);
  if (file == arguments.inputs.end()) return make_random_scene(arguments);
  if (arguments.inputs.size() > 1) {
    throw UsageError("a scene file stands alone", *file, "give one scene file, or families");
  }
  if (!arguments.random_options.empty()) {
    throw UsageError(fmt::format("{} is for random scenes", arguments.random_options.front()),
                     *file, "write it into the scene file");
  }
  return scene::read_scene(*file);
}

}  // namespace tagmint::cli
