#include "cli/detect_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <stdexcept>

#include "cli/camera_option.h"
#include "cli/length.h"
#include "cli/options.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/errors.h"
#include "tagmint/detect/detector.h"

namespace tagmint::cli {
namespace {

namespace fs = std::filesystem;

std::vector<std::shared_ptr<const codec::Decoder>> make_decoders(const DetectArguments& arguments) {
  std::vector<std::shared_ptr<const codec::Decoder>> decoders;
  std::set<std::string> names;
  for (const std::string& name : arguments.families) {
    const codec::SharedFamily family = codec::load_family(name);
    if (!names.insert(family->name()).second) {
      throw UsageError(fmt::format("the family {} is given twice", family->name()), "--family",
                       "give each once");
    }
    decoders.push_back(
        std::make_shared<const codec::Decoder>(make_decoder(family, arguments.decoding)));
  }
  return decoders;
}

std::optional<draw::AxesSetting> plan_poses(const DetectArguments& arguments) {
  if (arguments.camera.empty() && arguments.edge.empty() && arguments.distortion.empty()) {
    return std::nullopt;
  }
  if (arguments.camera.empty()) {
    throw UsageError("poses need the camera", arguments.edge.empty() ? "--distortion" : "--edge",
                     "add --camera FX,FY,CX,CY");
  }
  if (arguments.edge.empty()) {
    throw UsageError("poses need the side of the border square", "--camera",
                     "add --edge LEN, for example --edge 40mm");
  }
  const double edge_mm = parse_length_mm(arguments.edge, "--edge");
  if (edge_mm <= 0) throw UsageError("the edge must be above 0", "--edge", "give its length");
  return draw::AxesSetting{parse_camera(arguments.camera, arguments.distortion), edge_mm / 1000};
}

std::string name_of_image(const std::string& image) {
  return image == "-" ? "stdin" : fs::path(image).stem().string();
}

/// The overlay of one image: the pattern with {name} filled in, or a file in a folder.
fs::path overlay_path(const std::string& pattern, const std::string& name) {
  constexpr std::string_view kName = "{name}";
  std::error_code error;
  const bool folder = pattern.ends_with('/') || fs::is_directory(pattern, error);
  if (folder) return fs::path(pattern) / (name + "-overlay.png");
  std::string path = pattern;
  for (std::size_t at = path.find(kName); at != std::string::npos;
       at = path.find(kName, at + name.size())) {
    path.replace(at, kName.size(), name);
  }
  if (fs::path(path).extension() != ".png") {
    throw UsageError(fmt::format("'{}' does not end in .png", pattern), "--overlay",
                     "overlays are PNG files");
  }
  return path;
}

/// Refuses two images whose files would be the same one, and an overlay over one of the images.
void require_own_files(const std::vector<ImageTask>& tasks) {
  for (const ImageTask& task : tasks) {
    for (const ImageTask& other : tasks) {
      std::error_code error;
      if (!task.overlay.empty() && fs::equivalent(task.overlay, other.image, error)) {
        throw UsageError(fmt::format("the overlay would replace the image {}", other.image),
                         "--overlay", "choose another name");
      }
    }
  }
  std::map<fs::path, std::string> owners;
  for (const ImageTask& task : tasks) {
    for (const fs::path& path : {task.overlay, task.debug_folder}) {
      if (path.empty()) continue;
      const auto [owner, is_new] = owners.emplace(path, task.image);
      if (!is_new) {
        throw UsageError(fmt::format("{} and {} would both be written to {}", owner->second,
                                     task.image, path.string()),
                         task.overlay.empty() ? "--debug" : "--overlay",
                         "use {name} in the file's name and images of different names, or give "
                         "them one by one");
      }
    }
  }
}

/// Whether the name ends like that of a picture that can be read.
bool is_named_like_an_image(const fs::path& path) {
  static const std::set<std::string> kEndings = {".png", ".jpg", ".jpeg", ".pgm",
                                                 ".ppm", ".pnm", ".tif",  ".tiff"};
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return kEndings.contains(ending);
}

/// The arguments with each folder replaced by the pictures in it, by name.
std::vector<std::string> pictures_of(const std::vector<std::string>& arguments) {
  std::vector<std::string> images;
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (argument == "-" || !fs::is_directory(argument, error)) {
      images.push_back(argument);
      continue;
    }
    std::vector<std::string> inside;
    for (fs::directory_iterator file(argument, error), end; !error && file != end;
         file.increment(error)) {
      if (is_named_like_an_image(file->path())) inside.push_back(file->path().string());
    }
    if (error) {
      throw codec::InputError("the folder cannot be read: " + error.message(), argument,
                              "choose another one");
    }
    if (inside.empty()) {
      throw codec::InputError("the folder has no picture", argument,
                              "it should hold PNG, JPEG, PNM or TIFF files");
    }
    std::sort(inside.begin(), inside.end());
    images.insert(images.end(), inside.begin(), inside.end());
  }
  return images;
}

std::vector<ImageTask> plan_tasks(const DetectArguments& arguments) {
  if (std::count(arguments.images.begin(), arguments.images.end(), "-") > 1) {
    throw UsageError("stdin is given twice", "-", "give it once");
  }
  std::vector<ImageTask> tasks;
  const std::vector<std::string> images = pictures_of(arguments.images);
  const bool several = images.size() > 1;
  for (const std::string& image : images) {
    ImageTask task{.image = image, .overlay = {}, .debug_folder = {}};
    const std::string name = name_of_image(image);
    if (!arguments.overlay.empty()) task.overlay = overlay_path(arguments.overlay, name);
    if (!arguments.debug.empty()) {
      task.debug_folder = several ? fs::path(arguments.debug) / name : fs::path(arguments.debug);
    }
    tasks.push_back(std::move(task));
  }
  require_own_files(tasks);
  return tasks;
}

}  // namespace

DetectPlan plan_detection(const DetectArguments& arguments) {
  DetectPlan plan;
  const std::vector<std::string> formats = {"text", "jsonl", "csv"};
  const bool text_file = fs::path(arguments.output).extension() == ".txt";
  plan.format = choose_format(arguments.format, text_file ? "" : arguments.output, formats, "text");
  plan.poses = plan_poses(arguments);
  plan.decoders = make_decoders(arguments);
  plan.detector = arguments.detector;
  plan.detector.algorithm =
      arguments.algorithm == "paper" ? detect::Algorithm::Paper : detect::Algorithm::Tracker;
  plan.detector.refine_edges = !arguments.no_refine;
  plan.detector.contrast_by_noise = !arguments.fixed_contrast;
  plan.detector.refine_photometric = !arguments.no_refine && !arguments.no_photometric;
  plan.detector.report_inverted = plan.detector.report_mirrored = arguments.unusual_prints;
  if (plan.poses && plan.poses->camera.distorts()) plan.detector.lens = plan.poses->camera;
  try {
    detect::Detector(plan.decoders, plan.detector);
  } catch (const std::invalid_argument& complaint) {
    throw usage_error(complaint, "detect");
  }
  plan.tasks = plan_tasks(arguments);
  return plan;
}

}  // namespace tagmint::cli
