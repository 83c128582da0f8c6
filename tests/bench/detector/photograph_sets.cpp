#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "detector/drawn_scene.h"
#include "detector/picture_set.h"
#include "io/images.h"
#include "tagmint/codec/errors.h"

namespace tagmint::bench {
namespace {

namespace fs = std::filesystem;

/// The image files in a folder and those below it, by path.
std::vector<std::string> picture_files(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  const auto follow = fs::directory_options::follow_directory_symlink;
  for (fs::recursive_directory_iterator at(folder, follow, error), end; !error && at != end;
       at.increment(error)) {
    const std::string extension = at->path().extension().string();
    const bool picture = extension == ".png" || extension == ".jpg" || extension == ".jpeg" ||
                         extension == ".pgm" || extension == ".ppm" || extension == ".tif";
    if (picture && at->is_regular_file()) files.push_back(at->path().string());
  }
  if (error) throw codec::InputError("the folder cannot be read", folder, "check the path");
  if (files.empty()) {
    throw codec::InputError("no picture is in the folder", folder, "name a folder with some");
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Files spread evenly over the list: pictures of one kind often stand side by side.
const std::string& spread_choice(const std::vector<std::string>& files, int index) {
  constexpr std::size_t kStride = 7919;  // a prime: all files come before one comes again
  return files[static_cast<std::size_t>(index) * kStride % files.size()];
}

}  // namespace

std::vector<PictureSet> photograph_sets(const std::string& folder, const PictureSize& size) {
  const auto files = std::make_shared<const std::vector<std::string>>(picture_files(folder));
  const int count = static_cast<int>(files->size());
  PictureSet plain{.name = "photographs", .about = "photographs without tags", .most = count};
  plain.draw = [files](int index, std::uint64_t) {
    return Picture{io::read_gray_image(spread_choice(*files, index)), {}};
  };
  PictureSet pasted{.name = "pasted",
                    .about = "54 tags of 8 to 100 px pasted into photographs, noise 2, blur 0.7 px",
                    .most = count};
  pasted.draw = [files, size](int index, std::uint64_t seed) {
    const std::string& file = spread_choice(*files, index);
    scene::RandomSceneOptions options;
    options.width = size.width;
    options.height = size.height;
    options.count = 54;
    options.min_side_px = 10;  // tilted, 8 px
    options.max_side_px = 100;
    options.background = scene::PhotoBackground{file, io::read_gray_image(file)};
    options.effects = camera_effects(2);
    options.seed = picture_seed(seed, index);
    const std::vector<std::string> family = {"tag36h11"};
    return picture_of(scene::random_scene(choices_of(family), options));
  };
  return {pasted, plain};
}

PictureSet labelled_set(const std::string& folder) {
  const fs::path file = fs::path(folder) / "labels.json";
  std::ifstream stream(file);
  const nlohmann::json labels = nlohmann::json::parse(stream, nullptr, false);
  if (!stream || !labels.is_array()) {
    throw codec::InputError("the labels cannot be read", file.string(),
                            "name a folder with pictures and labels.json");
  }
  PictureSet set{.name = "labelled",
                 .about = "photographs; recall and false are agreement with the labels",
                 .most = static_cast<int>(labels.size()),
                 .whole = true};
  set.draw = [labels, folder](int index, std::uint64_t) {
    const nlohmann::json& entry = labels.at(static_cast<std::size_t>(index));
    const std::string name = entry.at("file");
    Picture picture{io::read_gray_image((fs::path(folder) / name).string()), {}};
    for (const nlohmann::json& label : entry.at("tags")) {
      TrueTag& tag = picture.tags.emplace_back();
      tag.family = "tag36h11";
      tag.id = label.at("id").get<codec::TagId>();
      for (std::size_t k = 0; k < 4; ++k) {
        tag.corners[k] = {label.at("corners").at(k).at(0), label.at("corners").at(k).at(1)};
      }
    }
    return picture;
  };
  return set;
}

}  // namespace tagmint::bench
