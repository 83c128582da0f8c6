#include "cli/cmd_render.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/length.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/render_plan.h"
#include "cli/seed_option.h"
#include "cli/terminal.h"
#include "io/images.h"
#include "scene/render.h"
#include "scene/scene_file.h"

namespace tagmint::cli {
namespace {

/// The picture as a file of one of the formats.
std::string encode(const scene::Rendering& rendering, const std::string& format) {
  constexpr int kQuality = 95;  // where the scene asks for none
  const detect::ImageView image = rendering.image.view();
  if (format == "png") return io::encode_png(image);
  if (format != "jpg" && format != "jpeg") return io::encode_pnm(image);
  return rendering.jpeg.empty() ? io::encode_jpeg(image, kQuality) : rendering.jpeg;
}

int run(const RenderArguments& arguments, const Common& common) {
  const std::vector<std::string> formats = {"png", "pgm", "pnm", "jpg", "jpeg"};
  const std::string format = choose_format(arguments.format, arguments.output, formats, "png");
  if (is_stdout(arguments.output) && is_stdout(arguments.truth) && !arguments.truth.empty()) {
    throw UsageError("image and truth cannot both go to stdout", "--truth", "give one a file");
  }
  if (!is_stdout(arguments.truth) && arguments.truth == arguments.output) {
    throw UsageError("image and truth would be the same file", "--truth", "give each its own");
  }
  if (!is_stdout(arguments.output)) require_writable(arguments.output);
  if (!is_stdout(arguments.truth)) require_writable(arguments.truth);
  const scene::Scene scene = plan_scene(arguments);
  const scene::Rendering rendering = scene::render(scene, common.threads);
  write_output(arguments.output, encode(rendering, format));
  if (!arguments.truth.empty()) {
    write_output(arguments.truth, scene::format_truth(scene, rendering.truth));
  }
  say(common, fmt::format("{} x {} px, {} tag{}", scene.width, scene.height, scene.tags.size(),
                          scene.tags.size() == 1 ? "" : "s"));
  return kDone;
}

/// Options of random scenes; plan_scene() refuses those that were given beside a scene file.
void add_random_options(CLI::App& app, RenderArguments& arguments) {
  const std::string group = "Random scenes";
  scene::RandomSceneOptions& random = arguments.random;
  app.add_option("--ids", arguments.ids, "ids to show")
      ->type_name("LIST")
      ->default_str("any")
      ->group(group);
  app.add_option("--count", arguments.count, "number of tags")
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000))
      ->default_str(fmt::format("up to {}, or all --ids", kDefaultCount))
      ->group(group);
  app.add_option("--size", arguments.size, "image size, px")->type_name("WxH")->group(group);
  app.add_option("--min-side", random.min_side_px, "smallest border square, px")
      ->type_name("PX")
      ->check(number_between(1, scene::kMaxSide_px))
      ->group(group);
  app.add_option("--max-side", random.max_side_px, "largest border square, px")
      ->type_name("PX")
      ->check(number_between(1, scene::kMaxSide_px))
      ->group(group);
  app.add_option("--min-tilt", random.min_tilt_deg, "smallest tilt, degrees")
      ->type_name("DEG")
      ->check(number_between(0, 85))
      ->group(group);
  app.add_option("--max-tilt", random.max_tilt_deg, "largest tilt, degrees")
      ->type_name("DEG")
      ->check(number_between(0, 85))
      ->group(group);
  app.add_option_function<std::string>(
         "--edge",
         [&random](const std::string& text) {
           random.edge_m = parse_length_mm(text, "--edge") / 1000;
           if (random.edge_m <= 0) {
             throw UsageError("the edge must be above 0", "--edge", "give its length");
           }
         },
         "side of the border squares in space")
      ->type_name("LEN")
      ->default_str("100mm")
      ->group(group);
  app.add_option("--quiet-zone", random.quiet_zone_cells, "white cells around each tag")
      ->type_name("N")
      ->check(CLI::Range(0, 64))
      ->group(group);
  app.add_option("--background", arguments.background,
                 "gray:N, gradient:A,B, clutter, a file; else texture")
      ->type_name("WHAT")
      ->default_str("")
      ->group(group);
  app.add_option("--noise", random.effects.noise_sigma, "sigma of the noise, gray levels")
      ->type_name("S")
      ->check(number_between(0, 255))
      ->group(group);
  app.add_option("--blur", random.effects.blur_sigma_px, "sigma of the blur, px")
      ->type_name("PX")
      ->check(number_between(0, 1000))
      ->group(group);
  app.add_option("--shading", random.effects.shading.strength, "share of the light that is lost")
      ->type_name("0..1")
      ->check(number_between(0, 0.99))
      ->group(group);
  app.add_option("--vignetting", random.effects.vignetting, "share lost in the corners")
      ->type_name("0..1")
      ->check(number_between(0, 0.99))
      ->group(group);
  app.add_option("--motion-blur", arguments.motion_blur, "length of the movement and its direction")
      ->type_name("PX[,DEG]")
      ->group(group);
  app.add_option("--defocus", random.effects.defocus_px, "radius of the blur out of focus, px")
      ->type_name("PX")
      ->check(number_between(0, 100))
      ->group(group);
  app.add_option("--electrons", random.effects.electrons_per_level,
                 "a gray level's, for shot noise; 0 = none")
      ->type_name("N")
      ->check(number_between(0, 1e6))
      ->group(group);
  app.add_option("--jpeg", random.effects.jpeg_quality, "quality of a JPEG on the way; 0 = none")
      ->type_name("Q")
      ->check(CLI::Range(0, 100))
      ->group(group);
  app.add_option("--gamma", random.effects.gamma, "of the camera")
      ->type_name("G")
      ->check(number_between(0.1, 10))
      ->group(group);
  add_seed(app, random.seed)->group(group);
}

std::vector<std::string> given_random_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group() == "Random scenes" && option->count() > 0) {
      names.push_back(option->get_name());
    }
  }
  return names;
}

Runner set_up(CLI::App& app, const Common& common) {
  auto arguments = std::make_shared<RenderArguments>();
  arguments->random.effects = {.black = 30,
                               .white = 220,
                               .shading = {.strength = 0.2, .angle_deg = 30},
                               .blur_sigma_px = 0.7,
                               .noise_sigma = 2};
  app.add_option("INPUT", arguments->inputs, "a scene file, or families for a random scene")
      ->required();
  add_output(app, arguments->output, "PNG, JPEG or PGM image, by its extension")->required();
  add_choice(app, "--format", arguments->format, {"png", "jpg", "pgm"}, "form of the image")
      ->default_str("by -o");
  app.add_option("--truth", arguments->truth, "write the true corners and poses")
      ->type_name("FILE.json");
  add_random_options(app, *arguments);
  return [arguments, &app, &common] {
    arguments->random_options = given_random_options(app);
    return run(*arguments, common);
  };
}

}  // namespace

Command render_command() {
  return {.name = "render",
          .summary = "draw synthetic camera images with ground truth",
          .examples = {"tagmint render scene.json -o scene.png --truth truth.json",
                       "tagmint render tag36h11 --count 12 --max-tilt 60 --noise 5 -o random.png"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
